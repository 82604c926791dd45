"""Programs on the runtime: pictures, SPACAR files, tables of flexures, sweeps and the command line."""

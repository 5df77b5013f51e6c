/** The provenance of results: the program, its version, the command, and the hashes of the scene and its models. */
package org.dronewatch.report.provenance;

/** Where results come from: the program, its version, the command, and which bytes the scene and its models had. */
package org.dronewatch.report.provenance;

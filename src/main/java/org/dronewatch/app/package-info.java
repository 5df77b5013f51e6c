/** The command line: reads the command, runs it, reports. It has no logic. */
package org.dronewatch.app;

/** The command line: a class for each command, without other logic. */
package org.dronewatch.app;

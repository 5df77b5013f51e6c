/** The command line: reads what is asked, runs it, reports. No logic of its own. */
package org.dronewatch.app;

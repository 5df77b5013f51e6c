/** The command line: reads what is asked, runs it, reports. It has no logic. */
package org.dronewatch.app;

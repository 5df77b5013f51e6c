/** What commands share at the terminal: notes, progress, interruption and exit codes. */
package org.dronewatch.app.console;

/** What commands have in common at the terminal: notes, progress, interruption and exit codes. */
package org.dronewatch.app.console;

/** How all reports write their files: completely or not at all, and with numbers that any program can read. */
package org.dronewatch.report.file;

/** How all reports write their files: whole or not at all, and with numbers that any program reads. */
package org.dronewatch.report.file;

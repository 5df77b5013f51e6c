/** Where sensors detect a drone, and why not elsewhere: tables, maps and {@code coverage.json}. */
package org.dronewatch.report.coverage;

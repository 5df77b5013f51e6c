/** Coverage and its gaps in tables and in words. */
package org.dronewatch.report.coverage.table;

/** What {@code place} prints and writes. */
package org.dronewatch.report.placement;

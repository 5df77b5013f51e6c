/**
 * The run that a window shows, as far as it has been recorded, and the layout of its sensors, which users may
 * change.
 */
package org.dronewatch.viewer.run;

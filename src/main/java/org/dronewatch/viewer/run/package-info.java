/**
 * The run that a window shows, up to the time to which it has been recorded, and the layout of its sensors, which users
 * may change.
 */
package org.dronewatch.viewer.run;

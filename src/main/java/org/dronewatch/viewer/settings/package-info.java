/** The settings of a sensor, which are edited in place. */
package org.dronewatch.viewer.settings;

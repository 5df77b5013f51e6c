/**
 * Alert rules: they combine the looks of several sensors to one decision, when there is an alert, and by which sensors.
 */
package org.dronewatch.fusion;

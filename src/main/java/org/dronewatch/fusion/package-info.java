/**
 * Alert rules, which combine the looks of several sensors into one decision: whether there is an alert and which
 * sensors raise it.
 */
package org.dronewatch.fusion;

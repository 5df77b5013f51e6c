/** From the observations of single sensors to one decision: when there is an alert, and from which sensors. */
package org.dronewatch.fusion;

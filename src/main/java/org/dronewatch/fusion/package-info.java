/** From what single sensors observe to one decision: when a site is alerted to a drone, and by whom. */
package org.dronewatch.fusion;

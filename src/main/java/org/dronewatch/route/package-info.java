/** The route to a protected zone on which a drone is least exposed, and whether it is detected in time. */
package org.dronewatch.route;

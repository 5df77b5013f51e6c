/** Layouts that leave no weak route for a drone: the search for them, and the routes past each. */
package org.dronewatch.placement.route;

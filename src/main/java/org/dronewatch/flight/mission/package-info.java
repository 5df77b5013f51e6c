/** Missions of QGroundControl as flights, and flights as missions. */
package org.dronewatch.flight.mission;

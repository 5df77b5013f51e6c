/** QGroundControl missions as flights, and flights as missions. */
package org.dronewatch.flight.mission;

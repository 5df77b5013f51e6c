/** Flights from files of other programs: what missions and tracks have in common. */
package org.dronewatch.flight.file;

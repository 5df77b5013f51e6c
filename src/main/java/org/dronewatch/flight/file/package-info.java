/** Flights from files of other programs: the common parts of missions and tracks. */
package org.dronewatch.flight.file;

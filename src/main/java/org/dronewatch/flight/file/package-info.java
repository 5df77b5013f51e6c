/** Flights from files of other programs: missions of QGroundControl, tracks in GPX, logs in CSV. */
package org.dronewatch.flight.file;

/** Recorded flights: tracks in GPX and logs in CSV. */
package org.dronewatch.flight.track;

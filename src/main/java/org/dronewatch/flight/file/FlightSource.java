package org.dronewatch.flight.file;

import java.util.function.Consumer;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.setting.input.FileHash;
import org.dronewatch.world.Places;

/** A flight file that has been read. Immutable. */
public interface FlightSource {

    /** The file's name and the hash of its bytes, as read. */
    FileHash hash();

    /** A one-line description of the file's content. */
    String description();

    /**
     * The flight over a site.
     *
     * @param places converts places on the map to positions on the site; queried only before this method returns
     * @param drone the speeds and the acceleration of the drone, which apply where the file states none
     * @param warnings receives a line for each item of the file that is not flown as stated there
     * @throws IllegalArgumentException when a place in the file has no position on this site; the message names it
     */
    FlightPath path(Places places, DroneSpeeds drone, Consumer<String> warnings);
}

package org.dronewatch.flight.track;

import java.nio.file.Path;
import java.util.Optional;
import org.dronewatch.flight.file.FlightFromFile;
import org.dronewatch.flight.file.FlightSource;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.FileName;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.input.BoundedFile;

/**
 * A flight recorded in a GPX track or a CSV log, flown in a straight line at constant speed from each point to the
 * next: the drone passes each point at its recorded time, and the time of the first point is the start of the run. The
 * drone stays at the last point. Without times, it flies through the points as with {@code waypoints}.
 *
 * @param log path of the {@code .gpx} or {@code .csv} file
 * @param heights level from which the heights in the file are measured
 * @param verticalOffset offset that is added to all heights, -10,000 to 10,000 m
 * @param track name of the track, for a GPX file that has several
 */
public record Track(
        @FileName String log,
        Heights heights,
        @In(value = Quantity.LENGTH, from = -10_000, to = 10_000) double verticalOffset,
        Optional<String> track)
        implements FlightFromFile {
    /** The largest file that is read, bytes. */
    static final int LARGEST = 64 << 20;

    /** The level from which the heights in a file are measured. */
    public enum Heights {
        /** Sea level, as for the height of the scene's origin. */
        SEA,
        /** The first point, which lies on the surface. */
        START,
        /** The surface below each point; a point without a height is on it. */
        SURFACE
    }

    /** Checks the limits. */
    public Track {
        Limits.check(Track.class, log, heights, verticalOffset, track);
        if (log.isBlank()) {
            throw new IllegalArgumentException("log is empty: it must name a .gpx or .csv file");
        }
    }

    /** A track with heights above sea level. */
    @Defaults("log")
    public static Track of(String log) {
        return new Track(log, Heights.SEA, 0.0, Optional.empty());
    }

    @Override
    public String file() {
        return log;
    }

    @Override
    public String fileSetting() {
        return "log";
    }

    @Override
    public FlightSource read(Path path, String shown) {
        byte[] bytes = BoundedFile.read(path, LARGEST);
        int first = 0;
        while (first < bytes.length && (bytes[first] < 0 || Character.isWhitespace(bytes[first]))) {
            first++;
        }
        // A GPX file begins with its first element, perhaps after a byte order mark.
        boolean isXml = first < bytes.length && bytes[first] == '<';
        return new TrackedFlight(
                this, isXml ? GpxFile.read(shown, bytes, track) : CsvLog.read(shown, bytes, heights, track), bytes);
    }
}

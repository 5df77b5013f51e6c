package org.dronewatch.flight.track;

import java.time.DateTimeException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import org.dronewatch.geo.EarthPoint;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Spelling;
import org.dronewatch.setting.input.XmlText;

/** Reads a track or a route of a GPX file (1.0 or 1.1). */
final class GpxFile {
    private static final double HIGHEST = 100_000.0;
    /** The depth in the file of an element that belongs directly to a track. */
    private static final int DEPTH_IN_TRACK = 3;

    private static final int LONGEST_TEXT = 200;

    private final String name;
    private final Map<String, Course> tracks = new LinkedHashMap<>();
    private Course course;
    private String courseName = "";
    private int waypoints;

    /** A track or a route. */
    private final class Course {
        private final Fixes fixes = new Fixes(name);
        private int segments;
    }

    private GpxFile(String name) {
        this.name = name;
    }

    /**
     * Reads a file.
     *
     * @param shown name of the file in messages
     * @param wanted name of the track, if it has several
     * @throws InputException with a one-line message when the file is not GPX or has an invalid point; the message
     *     gives the line
     */
    static Fixes.Points read(String shown, byte[] bytes, Optional<String> wanted) {
        String name = PlainText.value(shown);
        GpxFile file = new GpxFile(name);
        XmlText.read(name, bytes, "gpx", xml -> {
            while (xml.hasNext()) {
                if (xml.next() == XMLStreamConstants.START_ELEMENT) {
                    file.start(xml);
                }
            }
        });
        return file.chosen(wanted);
    }

    /** Handles the start of an element. The name of a track comes before its points. */
    private void start(XmlText xml) throws XMLStreamException {
        switch (xml.element()) {
            case "trk", "rte" -> {
                course = new Course();
                courseName = "";
                String unnamed = xml.element().equals("trk") ? "track " : "route ";
                keep(unnamed + (tracks.size() + 1));
            }
            case "name" -> {
                // The name is that of the track, not of the file or of a point, nor one in an extension.
                boolean isOfTrack = xml.depth() == DEPTH_IN_TRACK;
                String text = xml.content();
                if (isOfTrack && course != null && course.fixes.size() == 0) {
                    tracks.remove(courseName);
                    keep(text.isBlank() ? courseName : text.strip());
                }
            }
            case "trkseg" -> {
                if (course != null) {
                    course.segments++;
                }
            }
            case "trkpt", "rtept" -> {
                if (course == null) {
                    throw new InputException(xml.at() + "a point outside of a track");
                }
                point(xml);
            }
            case "wpt" -> waypoints++;
            default -> {
                // Metadata, extensions and other content that is not needed.
            }
        }
    }

    private void keep(String called) {
        String free = called;
        for (int i = 2; tracks.containsKey(free); i++) {
            free = called + " " + i;
        }
        courseName = free;
        tracks.put(free, course);
    }

    private void point(XmlText xml) throws XMLStreamException {
        long line = xml.line();
        EarthPoint place = new EarthPoint(
                Math.toRadians(number(xml, "lat", xml.attribute("lat"), -90.0, 90.0)),
                Math.toRadians(number(xml, "lon", xml.attribute("lon"), -180.0, 180.0)));
        OptionalDouble height = OptionalDouble.empty();
        double time = Double.NaN;
        int inside = xml.depth();
        while (xml.depth() >= inside) {
            if (xml.next() != XMLStreamConstants.START_ELEMENT || xml.depth() > inside + 1) {
                continue;
            }
            if (xml.element().equals("ele")) {
                height = OptionalDouble.of(number(xml, "ele", xml.content(), -HIGHEST, HIGHEST));
            } else if (xml.element().equals("time")) {
                time = time(xml, xml.content().strip());
            }
        }
        course.fixes.add(new Fixes.Fix(line, time, place, height));
    }

    private double number(XmlText xml, String what, String text, double from, double to) {
        try {
            double value = Double.parseDouble(String.valueOf(text).strip());
            if (value >= from && value <= to) {
                return value;
            }
        } catch (NumberFormatException e) {
            throw new InputException(xml.at() + what + " '" + PlainText.value(text) + "' must be a number", e);
        }
        throw new InputException(xml.at() + what + " " + PlainText.value(text) + " must be " + from + " to " + to);
    }

    private double time(XmlText xml, String text) {
        try {
            return LogTime.seconds(text);
        } catch (DateTimeException e) {
            throw new InputException(
                    xml.at() + "time '" + PlainText.value(text) + "' must be written as in 2026-11-24T03:30:00Z", e);
        }
    }

    private Fixes.Points chosen(Optional<String> wanted) {
        tracks.values().removeIf(one -> one.fixes.size() == 0);
        List<String> names = tracks.keySet().stream().map(PlainText::value).toList();
        if (tracks.isEmpty()) {
            throw new InputException(name + ": has no track with points"
                    + (waypoints == 0
                            ? ""
                            : ", only "
                                    + Counted.of(
                                            waypoints,
                                            "individual waypoint, which does not make a flight",
                                            "individual waypoints, which do not make a flight")));
        }
        if (wanted.isPresent() && !tracks.containsKey(wanted.get())) {
            throw new InputException(name + ": has no track '" + PlainText.value(wanted.get()) + "'; "
                    + Spelling.closestMatches(wanted.get(), names));
        }
        if (wanted.isEmpty() && tracks.size() > 1) {
            throw new InputException(name + ": has " + tracks.size() + " tracks: give 'track', one of "
                    + PlainText.beginning(String.join(", ", names), LONGEST_TEXT));
        }
        Course one =
                tracks.get(wanted.orElseGet(() -> tracks.keySet().iterator().next()));
        List<String> notes = new ArrayList<>();
        if (one.segments > 1) {
            notes.add(one.segments + " segments of the track are joined by straight lines");
        }
        return one.fixes.points(notes);
    }
}

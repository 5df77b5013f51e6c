package org.dronewatch.flight.file;

import java.io.ByteArrayInputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.time.DateTimeException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import org.dronewatch.geo.EarthPoint;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Spelling;

/** Reads a track or a route of a GPX file (1.0 or 1.1). */
final class GpxFile {
    private static final double HIGHEST = 100_000.0;
    private static final int LONGEST_TEXT = 200;
    private static final int MOST_DEPTH = 64;

    private final String name;
    private final Map<String, Course> tracks = new LinkedHashMap<>();
    private Course course;
    private String courseName = "";
    private int depth;
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
     * @param shown its name, for messages
     * @param wanted name of the track, if it has several
     * @throws InputException in one line when it is not GPX, or the point in a line is wrong
     */
    static Fixes.Points read(String shown, byte[] bytes, Optional<String> wanted) {
        String name = PlainText.value(shown);
        XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
        // A track has no document type: nothing is expanded, and no other file is read.
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        GpxFile file = new GpxFile(name);
        try {
            file.read(factory.createXMLStreamReader(text(bytes)));
        } catch (XMLStreamException e) {
            int line = e.getLocation() == null ? 1 : e.getLocation().getLineNumber();
            String why = String.valueOf(e.getMessage()).replaceFirst("(?s).*Message: ", "");
            throw new InputException(name + ":" + line + ": not whole XML: " + PlainText.line(why), e);
        }
        return file.chosen(wanted);
    }

    private static Reader text(byte[] bytes) {
        boolean marked =
                bytes.length > 2 && bytes[0] == (byte) 0xEF && bytes[1] == (byte) 0xBB && bytes[2] == (byte) 0xBF;
        int from = marked ? 3 : 0;
        return new InputStreamReader(
                new ByteArrayInputStream(bytes, from, bytes.length - from), StandardCharsets.UTF_8);
    }

    private void read(XMLStreamReader xml) throws XMLStreamException {
        boolean begun = false;
        while (xml.hasNext()) {
            int event = xml.next();
            if (event == XMLStreamConstants.DTD) {
                throw new InputException(at(xml) + "has a document type, which no GPX file needs");
            }
            if (event == XMLStreamConstants.START_ELEMENT) {
                if (!begun && !xml.getLocalName().equals("gpx")) {
                    throw new InputException(at(xml) + "begins with <" + PlainText.value(xml.getLocalName())
                            + ">, must begin with <gpx>: not a track");
                }
                begun = true;
                depth++;
                if (depth > MOST_DEPTH) {
                    throw new InputException(at(xml) + "nested more than " + MOST_DEPTH + " deep");
                }
                start(xml);
            } else if (event == XMLStreamConstants.END_ELEMENT) {
                depth--;
            }
        }
    }

    /** Names of tracks stand before their points. */
    private void start(XMLStreamReader xml) throws XMLStreamException {
        switch (xml.getLocalName()) {
            case "trk", "rte" -> {
                course = new Course();
                courseName = "";
                String unnamed = xml.getLocalName().equals("trk") ? "track " : "route ";
                keep(unnamed + (tracks.size() + 1));
            }
            case "name" -> {
                String text = content(xml);
                if (course != null && course.fixes.size() == 0 && depth == 2) {
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
                    throw new InputException(at(xml) + "a point outside of a track");
                }
                point(xml);
            }
            case "wpt" -> waypoints++;
            default -> {
                // Metadata, extensions and the like.
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

    private String content(XMLStreamReader xml) throws XMLStreamException {
        StringBuilder text = new StringBuilder();
        int inner = 1;
        while (inner > 0) {
            int event = xml.next();
            if (event == XMLStreamConstants.START_ELEMENT) {
                inner++;
            } else if (event == XMLStreamConstants.END_ELEMENT) {
                inner--;
            } else if (xml.isCharacters() && text.length() < LONGEST_TEXT) {
                text.append(xml.getText(), 0, Math.min(xml.getText().length(), LONGEST_TEXT));
            }
        }
        depth--;
        return text.toString();
    }

    private void point(XMLStreamReader xml) throws XMLStreamException {
        long line = xml.getLocation().getLineNumber();
        EarthPoint place = new EarthPoint(
                Math.toRadians(number(xml, "lat", xml.getAttributeValue(null, "lat"), -90.0, 90.0)),
                Math.toRadians(number(xml, "lon", xml.getAttributeValue(null, "lon"), -180.0, 180.0)));
        OptionalDouble height = OptionalDouble.empty();
        double time = Double.NaN;
        int inner = 1;
        while (inner > 0) {
            int event = xml.next();
            if (event == XMLStreamConstants.END_ELEMENT) {
                inner--;
            } else if (event == XMLStreamConstants.START_ELEMENT
                    && inner == 1
                    && xml.getLocalName().equals("ele")) {
                depth++;
                height = OptionalDouble.of(number(xml, "ele", content(xml), -HIGHEST, HIGHEST));
            } else if (event == XMLStreamConstants.START_ELEMENT
                    && inner == 1
                    && xml.getLocalName().equals("time")) {
                depth++;
                time = time(xml, content(xml).strip());
            } else if (event == XMLStreamConstants.START_ELEMENT) {
                inner++;
            }
            if (inner > MOST_DEPTH) {
                throw new InputException(at(xml) + "nested more than " + MOST_DEPTH + " deep");
            }
        }
        depth--;
        course.fixes.add(new Fixes.Fix(line, time, place, height));
    }

    private double number(XMLStreamReader xml, String what, String text, double from, double to) {
        try {
            double value = Double.parseDouble(String.valueOf(text).strip());
            if (value >= from && value <= to) {
                return value;
            }
        } catch (NumberFormatException e) {
            throw new InputException(at(xml) + what + " '" + PlainText.value(text) + "' must be a number", e);
        }
        throw new InputException(at(xml) + what + " " + PlainText.value(text) + " must be " + from + " to " + to);
    }

    private double time(XMLStreamReader xml, String text) {
        try {
            return LogTime.seconds(text);
        } catch (DateTimeException e) {
            throw new InputException(
                    at(xml) + "time '" + PlainText.value(text) + "' must be as in 2026-11-24T03:30:00Z", e);
        }
    }

    private String at(XMLStreamReader xml) {
        return name + ":" + xml.getLocation().getLineNumber() + ": ";
    }

    private Fixes.Points chosen(Optional<String> wanted) {
        tracks.values().removeIf(one -> one.fixes.size() == 0);
        List<String> names = tracks.keySet().stream().map(PlainText::value).toList();
        if (tracks.isEmpty()) {
            throw new InputException(name + ": has no track with points"
                    + (waypoints == 0 ? "" : ", only " + waypoints + " single waypoints, which are no flight"));
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

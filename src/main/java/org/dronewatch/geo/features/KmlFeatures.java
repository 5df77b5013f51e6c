package org.dronewatch.geo.features;

import java.io.ByteArrayInputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/** Reads the placemarks of KML 2.2 that have a name. */
final class KmlFeatures {
    private static final Set<String> SHAPES =
            Set.of("Point", "LineString", "LinearRing", "Polygon", "MultiGeometry", "Track", "MultiTrack", "Model");

    private static final int MOST_DEPTH = 64;
    private static final int LONGEST_TEXT = 1000;

    private final String file;
    private final Features.Found found;
    private int depth;

    KmlFeatures(String file, Features.Found found) {
        this.file = file;
        this.found = found;
    }

    void read(byte[] bytes) {
        XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
        // A map has no document type: nothing is expanded, and no other file is read.
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        factory.setProperty(XMLInputFactory.IS_COALESCING, true);
        try {
            read(factory.createXMLStreamReader(text(bytes)));
        } catch (XMLStreamException e) {
            int line = e.getLocation() == null ? 1 : e.getLocation().getLineNumber();
            String why = String.valueOf(e.getMessage()).replaceFirst("(?s).*Message: ", "");
            throw new InputException(file + ":" + line + ": not whole XML: " + PlainText.line(why), e);
        }
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
            int event = next(xml);
            if (event == XMLStreamConstants.START_ELEMENT) {
                if (!begun && !xml.getLocalName().equals("kml")) {
                    throw new InputException(at(xml) + "begins with <" + PlainText.value(xml.getLocalName())
                            + ">, must begin with <kml>");
                }
                begun = true;
                if (xml.getLocalName().equals("Placemark")) {
                    placemark(xml);
                }
            }
        }
    }

    private int next(XMLStreamReader xml) throws XMLStreamException {
        int event = xml.next();
        if (event == XMLStreamConstants.DTD) {
            throw new InputException(at(xml) + "has a document type, which no KML file needs");
        }
        if (event == XMLStreamConstants.START_ELEMENT && ++depth > MOST_DEPTH) {
            throw new InputException(at(xml) + "nested more than " + MOST_DEPTH + " deep");
        }
        if (event == XMLStreamConstants.END_ELEMENT) {
            depth--;
        }
        return event;
    }

    /** Up to its end. */
    private void placemark(XMLStreamReader xml) throws XMLStreamException {
        int outer = depth;
        String line = Integer.toString(xml.getLocation().getLineNumber());
        String name = "";
        String shape = "feature without a place";
        String coordinates = "";
        String mode = "clampToGround";
        while (depth >= outer) {
            if (next(xml) != XMLStreamConstants.START_ELEMENT) {
                continue;
            }
            String element = xml.getLocalName();
            if (depth == outer + 1 && element.equals("name")) {
                name = content(xml);
            } else if (depth == outer + 1 && SHAPES.contains(element)) {
                shape = element;
            } else if (depth == outer + 2 && shape.equals("Point") && element.equals("coordinates")) {
                coordinates = content(xml);
            } else if (depth == outer + 2 && shape.equals("Point") && element.equals("altitudeMode")) {
                mode = content(xml).strip();
            }
        }
        if (!name.isBlank()) {
            found.add(name, shape.equals("Point") ? point(coordinates, mode, line) : nowhere(line, shape));
        }
    }

    private static Feature nowhere(String line, String shape) {
        return new Feature(
                line, shape, Optional.empty(), OptionalDouble.empty(), OptionalDouble.empty(), OptionalDouble.empty());
    }

    private Feature point(String coordinates, String mode, String line) {
        String[] numbers = coordinates.strip().split("\\s*,\\s*", -1);
        double[] values = new double[3];
        try {
            if (numbers.length < 2 || numbers.length > 3) {
                throw new NumberFormatException();
            }
            for (int i = 0; i < numbers.length; i++) {
                values[i] = Double.parseDouble(numbers[i]);
            }
        } catch (NumberFormatException e) {
            throw new InputException(
                    file + ":" + line + ": coordinates '" + PlainText.value(coordinates.strip())
                            + "' must be longitude,latitude or longitude,latitude,height",
                    e);
        }
        double height = found.number(values[2], line, "height", Features.HIGHEST);
        boolean isAbove = mode.equals("relativeToGround");
        return new Feature(
                line,
                "Point",
                Optional.of(found.point(values[0], values[1], line)),
                isAbove ? OptionalDouble.of(Math.max(0.0, height)) : OptionalDouble.empty(),
                mode.equals("absolute") ? OptionalDouble.of(height) : OptionalDouble.empty(),
                OptionalDouble.empty());
    }

    private String content(XMLStreamReader xml) throws XMLStreamException {
        StringBuilder text = new StringBuilder();
        int outer = depth;
        while (depth >= outer) {
            next(xml);
            if (xml.isCharacters() && text.length() < LONGEST_TEXT) {
                text.append(xml.getText(), 0, Math.min(xml.getText().length(), LONGEST_TEXT));
            }
        }
        return text.toString();
    }

    private String at(XMLStreamReader xml) {
        return file + ":" + xml.getLocation().getLineNumber() + ": ";
    }
}

package org.dronewatch.geo.features;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.input.XmlText;

/** Reads the placemarks of KML 2.2 that have a name. */
final class KmlFeatures {
    private static final Set<String> SHAPES =
            Set.of("Point", "LineString", "LinearRing", "Polygon", "MultiGeometry", "Track", "MultiTrack", "Model");

    private final String file;
    private final Features.Found found;

    KmlFeatures(String file, Features.Found found) {
        this.file = file;
        this.found = found;
    }

    void read(byte[] bytes) {
        XmlText.read(file, bytes, "kml", xml -> {
            while (xml.hasNext()) {
                if (xml.next() == XMLStreamConstants.START_ELEMENT
                        && xml.element().equals("Placemark")) {
                    placemark(xml);
                }
            }
        });
    }

    /** Up to its end. */
    private void placemark(XmlText xml) throws XMLStreamException {
        int inside = xml.depth();
        String line = Integer.toString(xml.line());
        String name = "";
        String shape = "feature without a place";
        String coordinates = "";
        String mode = "clampToGround";
        while (xml.depth() >= inside) {
            if (xml.next() != XMLStreamConstants.START_ELEMENT) {
                continue;
            }
            String element = xml.element();
            int below = xml.depth() - inside;
            if (below == 1 && element.equals("name")) {
                name = xml.content();
            } else if (below == 1 && SHAPES.contains(element)) {
                shape = element;
            } else if (below == 2 && shape.equals("Point") && element.equals("coordinates")) {
                coordinates = xml.content();
            } else if (below == 2 && shape.equals("Point") && element.equals("altitudeMode")) {
                mode = xml.content().strip();
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
}

package org.dronewatch.report.map;

import java.awt.Color;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.stream.Collectors;
import javax.xml.stream.XMLStreamException;
import org.dronewatch.geo.GeoPoint;

/**
 * A map as KML 2.2 (OGC 07-147r2). KML supports only heights above the sea and above its viewer's own ground. If the
 * height of the scene's origin is not known, points and lines are clamped to the ground; otherwise sensors, drones and
 * flights are drawn at their heights.
 */
final class Kml {
    private static final String NAMESPACE = "http://www.opengis.net/kml/2.2";

    private final DrawnFeatures content;

    Kml(DrawnFeatures content) {
        this.content = content;
    }

    void write(Path file) throws IOException {
        try (OutputStream stream = new BufferedOutputStream(Files.newOutputStream(file))) {
            write(new Elements(stream));
        } catch (XMLStreamException e) {
            throw new IOException(file + " cannot be written: " + e.getMessage(), e);
        }
    }

    private void write(Elements kml) throws XMLStreamException {
        kml.openRoot("kml", NAMESPACE);
        kml.open("Document");
        kml.text("name", content.title());
        kml.text("open", "1");
        kml.text("description", content.description());
        List<StyledFeature> features = content.features();
        for (String folder : content.folders()) {
            kml.open("Folder");
            kml.text("name", folder);
            for (StyledFeature feature : features) {
                if (feature.folder().equals(folder)) {
                    write(kml, feature);
                }
            }
            kml.close();
        }
        kml.close();
        kml.close();
        kml.end();
    }

    private void write(Elements kml, StyledFeature feature) throws XMLStreamException {
        kml.open("Placemark");
        kml.text("name", feature.name());
        writeStyle(kml, feature);
        kml.open("ExtendedData");
        for (Map.Entry<String, Object> property : feature.properties().entrySet()) {
            kml.open("Data");
            kml.attribute("name", property.getKey());
            kml.text("value", text(property.getValue()));
            kml.close();
        }
        kml.close();
        writeShape(kml, feature.shape());
        kml.close();
    }

    private static String text(Object value) {
        if (value instanceof BigDecimal number) {
            return number.toPlainString();
        }
        return value == null ? "" : value.toString();
    }

    private static void writeStyle(Elements kml, StyledFeature feature) throws XMLStreamException {
        kml.open("Style");
        if (feature.shape() instanceof Shape.Point) {
            writeIcon(kml, feature);
        } else {
            kml.open("LineStyle");
            kml.text("color", colour(feature.colour(), 1.0));
            kml.text("width", Double.toString(Role.STROKE));
            kml.close();
        }
        if (feature.shape() instanceof Shape.Area) {
            kml.open("PolyStyle");
            kml.text("color", colour(feature.colour(), Role.OPACITY));
            kml.close();
        }
        kml.close();
    }

    private static void writeIcon(Elements kml, StyledFeature feature) throws XMLStreamException {
        kml.open("IconStyle");
        kml.text("color", colour(feature.colour(), 1.0));
        kml.text("scale", Double.toString(feature.role().size().scale()));
        kml.close();
        if (!feature.role().isNamed()) {
            kml.open("LabelStyle");
            kml.text("scale", "0");
            kml.close();
        }
    }

    /** KML's order is opacity, blue, green, red. */
    private static String colour(Color colour, double opacity) {
        return String.format(
                Locale.ROOT,
                "%02x%02x%02x%02x",
                Math.round(255.0 * opacity),
                colour.getBlue(),
                colour.getGreen(),
                colour.getRed());
    }

    private void writeShape(Elements kml, Shape shape) throws XMLStreamException {
        if (shape instanceof Shape.Point point) {
            kml.open("Point");
            kml.text("altitudeMode", heights());
            kml.text("coordinates", coordinates(List.of(point.position()), GeoPoint::inSpace));
            kml.close();
        } else if (shape instanceof Shape.Line line) {
            kml.open("LineString");
            // Along the ground, not through it; or with a curtain down to it.
            kml.text(content.isInSpace() ? "extrude" : "tessellate", "1");
            kml.text("altitudeMode", heights());
            kml.text("coordinates", coordinates(line.positions(), GeoPoint::inSpace));
            kml.close();
        } else if (shape instanceof Shape.Area area) {
            writeArea(kml, area);
        }
    }

    private String heights() {
        return content.isInSpace() ? "absolute" : "clampToGround";
    }

    private static void writeArea(Elements kml, Shape.Area area) throws XMLStreamException {
        kml.open("Polygon");
        if (area.top().isPresent()) {
            kml.text("extrude", "1");
            kml.text("altitudeMode", "relativeToGround");
        } else {
            kml.text("tessellate", "1");
            kml.text("altitudeMode", "clampToGround");
        }
        for (int ring = 0; ring < area.rings().size(); ring++) {
            kml.open(ring == 0 ? "outerBoundaryIs" : "innerBoundaryIs");
            kml.open("LinearRing");
            kml.text("coordinates", coordinates(area.rings().get(ring), corner -> raised(corner, area.top())));
            kml.close();
            kml.close();
        }
        kml.close();
    }

    private static List<BigDecimal> raised(GeoPoint corner, OptionalDouble top) {
        return top.isPresent()
                ? new GeoPoint(corner.longitude(), corner.latitude(), top.getAsDouble()).inSpace()
                : corner.onPlan();
    }

    private static String coordinates(List<GeoPoint> positions, Function<GeoPoint, List<BigDecimal>> form) {
        return positions.stream()
                .map(position -> form.apply(position).stream()
                        .map(BigDecimal::toPlainString)
                        .collect(Collectors.joining(",")))
                .collect(Collectors.joining(" "));
    }
}

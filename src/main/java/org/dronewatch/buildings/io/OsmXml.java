package org.dronewatch.buildings.io;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/** Reads OpenStreetMap XML, the format of the main site, Overpass and JOSM, version 0.6. */
final class OsmXml {
    private static final char BYTE_ORDER_MARK = '\uFEFF';

    /** The map's own limit is 2000. */
    private static final int MOST_NODES = 1_000_000;

    private final String file;
    private final OsmElements target;
    private long id;
    private boolean isDeleted;
    private long[] nodes = new long[64];
    private int count;
    private List<OsmElements.Member> members = new ArrayList<>();
    private Map<String, String> tags = new HashMap<>();

    private OsmXml(String file, OsmElements target) {
        this.file = file;
        this.target = target;
    }

    /**
     * Reads a file to its end.
     *
     * @param file its name, for messages
     * @throws InputException with a one-line message when it is not OpenStreetMap XML
     * @throws IOException when it cannot be read
     */
    static void read(String file, InputStream in, OsmElements target) throws IOException {
        XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
        // A map has no document type: nothing is expanded, and no other file is read.
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        try {
            new OsmXml(file, target).read(factory.createXMLStreamReader(text(in)));
        } catch (XMLStreamException e) {
            int line = e.getLocation() == null ? 1 : e.getLocation().getLineNumber();
            String why = String.valueOf(e.getMessage()).replaceFirst("(?s).*Message: ", "");
            throw new InputException(file + ":" + line + ": not well-formed XML: " + PlainText.line(why), e);
        }
    }

    /** Always UTF-8; the parser would print what is wrong with bytes, in addition to throwing it. */
    private static Reader text(InputStream in) throws IOException {
        BufferedReader reader =
                new BufferedReader(new MarkupReader(new InputStreamReader(in, StandardCharsets.UTF_8)), 1 << 16);
        reader.mark(1);
        if (reader.read() != BYTE_ORDER_MARK) {
            reader.reset();
        }
        return reader;
    }

    private void read(XMLStreamReader xml) throws XMLStreamException, IOException {
        boolean isOsm = false;
        while (xml.hasNext()) {
            int event = xml.next();
            if (event == XMLStreamConstants.START_ELEMENT) {
                if (!isOsm && !xml.getLocalName().equals("osm")) {
                    throw new InputException(file + ": begins with <" + PlainText.value(xml.getLocalName())
                            + "> but must begin with <osm>: not an OpenStreetMap file");
                }
                isOsm = true;
                start(xml);
            } else if (event == XMLStreamConstants.END_ELEMENT) {
                end(xml.getLocalName());
            }
        }
    }

    private void start(XMLStreamReader xml) throws IOException {
        switch (xml.getLocalName()) {
            case "node" -> {
                begin(xml);
                if (!isDeleted) {
                    target.node(id, degrees(xml, "lon", 180.0), degrees(xml, "lat", 90.0));
                }
            }
            case "way", "relation" -> begin(xml);
            case "nd" -> {
                if (count == MOST_NODES) {
                    throw new IOException("a way with more than " + MOST_NODES + " nodes");
                }
                if (count == nodes.length) {
                    nodes = Arrays.copyOf(nodes, 2 * count);
                }
                nodes[count++] = number(xml, "ref");
            }
            case "member" -> {
                if ("way".equals(xml.getAttributeValue(null, "type"))) {
                    String role = xml.getAttributeValue(null, "role");
                    members.add(new OsmElements.Member(number(xml, "ref"), role == null ? "" : role));
                    OsmElements.checkMembers(members.size());
                }
            }
            case "tag" -> {
                String key = xml.getAttributeValue(null, "k");
                String value = xml.getAttributeValue(null, "v");
                if (key != null && value != null) {
                    tags.put(key, value);
                    OsmElements.checkTags(tags.size());
                }
            }
            default -> {
                // Bounds, notes and the like.
            }
        }
    }

    private void begin(XMLStreamReader xml) {
        id = number(xml, "id");
        isDeleted = "false".equals(xml.getAttributeValue(null, "visible"))
                || "delete".equals(xml.getAttributeValue(null, "action"));
        count = 0;
        members = new ArrayList<>();
        tags = new HashMap<>();
    }

    private void end(String element) {
        if (isDeleted) {
            return;
        }
        switch (element) {
            case "node" -> {
                if (!tags.isEmpty()) {
                    target.taggedNode(tags);
                }
            }
            case "way" -> target.way(id, Arrays.copyOf(nodes, count), tags);
            case "relation" -> target.relation(id, members, tags);
            default -> {
                // Only elements of the three kinds are complete here.
            }
        }
    }

    private long number(XMLStreamReader xml, String attribute) {
        String text = xml.getAttributeValue(null, attribute);
        try {
            return Long.parseLong(String.valueOf(text));
        } catch (NumberFormatException e) {
            throw wrong(xml, attribute, text, "a whole number", e);
        }
    }

    private double degrees(XMLStreamReader xml, String attribute, double most) {
        String text = xml.getAttributeValue(null, attribute);
        double value;
        try {
            value = Double.parseDouble(String.valueOf(text));
        } catch (NumberFormatException e) {
            throw wrong(xml, attribute, text, "a number", e);
        }
        if (!(Math.abs(value) <= most)) {
            throw wrong(xml, attribute, text, -most + " to " + most, null);
        }
        return value;
    }

    private InputException wrong(XMLStreamReader xml, String attribute, String text, String must, Exception cause) {
        String what = text == null ? " is missing; it" : "='" + PlainText.value(text) + "'";
        return new InputException(
                file + ":" + xml.getLocation().getLineNumber() + ": <" + xml.getLocalName() + "> " + attribute + what
                        + " must be " + must,
                cause);
    }
}

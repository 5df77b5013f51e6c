package org.dronewatch.setting.input;

import java.io.ByteArrayInputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/**
 * Reads XML files named by the user, always in UTF-8: no entity is expanded, no other file is read, and the nesting
 * depth and the length of texts are bounded. Each instance reads one document.
 */
public final class XmlText {
    private static final int MOST_DEPTH = 64;
    private static final int LONGEST_TEXT = 1000;
    private static final int MARK_BYTES = 3;

    private final String name;
    private final XMLStreamReader xml;
    private int depth;

    /** Receives the elements of a document. */
    @FunctionalInterface
    public interface Reading {
        /** Reads the document to its end. */
        void read(XmlText xml) throws XMLStreamException;
    }

    private XmlText(String name, XMLStreamReader xml) {
        this.name = name;
        this.xml = xml;
    }

    /**
     * Reads a document.
     *
     * @param name name of the document in messages
     * @param root name of the document's outermost element
     * @param reading receives the document, positioned inside that element
     * @throws InputException with a one-line message when it is not such a document
     */
    public static void read(String name, byte[] bytes, String root, Reading reading) {
        XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        boolean marked = bytes.length >= MARK_BYTES
                && bytes[0] == (byte) 0xEF
                && bytes[1] == (byte) 0xBB
                && bytes[2] == (byte) 0xBF;
        int from = marked ? MARK_BYTES : 0;
        // Decoded here: the parser would print what is wrong with bytes, in addition to throwing it.
        InputStreamReader text = new InputStreamReader(
                new ByteArrayInputStream(bytes, from, bytes.length - from), StandardCharsets.UTF_8);
        try {
            XmlText document = new XmlText(name, factory.createXMLStreamReader(text));
            document.begin(root);
            reading.read(document);
        } catch (XMLStreamException e) {
            int line = e.getLocation() == null ? 1 : e.getLocation().getLineNumber();
            String why = String.valueOf(e.getMessage()).replaceFirst("(?s).*Message: ", "");
            throw new InputException(
                    name + ":" + line + ": not well-formed XML: "
                            + PlainText.beginning(PlainText.line(why), PlainText.LONGEST),
                    e);
        }
    }

    private void begin(String root) throws XMLStreamException {
        while (next() != XMLStreamConstants.START_ELEMENT) {
            // What may come before the outermost element.
        }
        if (!element().equals(root)) {
            throw new InputException(
                    at() + "begins with <" + PlainText.value(element()) + "> but must begin with <" + root + ">");
        }
    }

    /** Whether there is more to read. */
    public boolean hasNext() throws XMLStreamException {
        return xml.hasNext();
    }

    /** Advances to the next event, as {@link XMLStreamReader#next()} does. */
    public int next() throws XMLStreamException {
        int event = xml.next();
        if (event == XMLStreamConstants.DTD) {
            throw new InputException(at() + "has a document type declaration, which is not allowed in such a file");
        }
        if (event == XMLStreamConstants.START_ELEMENT && ++depth > MOST_DEPTH) {
            throw new InputException(at() + "nested more than " + MOST_DEPTH + " deep");
        }
        if (event == XMLStreamConstants.END_ELEMENT) {
            depth--;
        }
        return event;
    }

    /** The nesting depth: the number of open elements. */
    public int depth() {
        return depth;
    }

    /** The name of the current element, without the prefix of its namespace. */
    public String element() {
        return xml.getLocalName();
    }

    /** An attribute of the current element; null if it has none of that name. */
    public String attribute(String called) {
        return xml.getAttributeValue(null, called);
    }

    /** The number of the current line. */
    public int line() {
        return xml.getLocation().getLineNumber();
    }

    /** The beginning of messages about the current line. */
    public String at() {
        return name + ":" + line() + ": ";
    }

    /** The text of the current element, up to its end; only the beginning of a very long one. */
    public String content() throws XMLStreamException {
        StringBuilder text = new StringBuilder();
        int inside = depth;
        int event = next();
        while (event != XMLStreamConstants.END_ELEMENT || depth >= inside) {
            if (xml.isCharacters() && text.length() < LONGEST_TEXT) {
                text.append(xml.getText(), 0, Math.min(xml.getTextLength(), LONGEST_TEXT));
            }
            event = next();
        }
        return text.toString();
    }
}

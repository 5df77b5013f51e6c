package org.dronewatch.report.map;

import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import javax.xml.stream.XMLOutputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;

/** Writes XML elements, each on its own line. */
final class Elements {
    private final XMLStreamWriter xml;
    private int depth;

    /** Begins a file. */
    Elements(OutputStream target) throws XMLStreamException {
        // The factory of the JDK, whatever else is on the class path, so that the same results give the same bytes.
        xml = XMLOutputFactory.newDefaultFactory().createXMLStreamWriter(target, StandardCharsets.UTF_8.name());
        xml.writeStartDocument(StandardCharsets.UTF_8.name(), "1.0");
    }

    /** Opens the outermost element, whose namespace is that of all. */
    void openRoot(String name, String namespace) throws XMLStreamException {
        open(name);
        xml.writeDefaultNamespace(namespace);
    }

    void open(String name) throws XMLStreamException {
        newLine();
        xml.writeStartElement(name);
        depth++;
    }

    /** Adds an attribute to the element opened last. */
    void attribute(String name, String value) throws XMLStreamException {
        xml.writeAttribute(name, allowed(value));
    }

    void close() throws XMLStreamException {
        depth--;
        newLine();
        xml.writeEndElement();
    }

    /** Writes an element that contains text. */
    void text(String name, String text) throws XMLStreamException {
        newLine();
        xml.writeStartElement(name);
        xml.writeCharacters(allowed(text));
        xml.writeEndElement();
    }

    /** Ends the file. */
    void end() throws XMLStreamException {
        xml.writeCharacters("\n");
        xml.writeEndDocument();
        xml.close();
    }

    private void newLine() throws XMLStreamException {
        xml.writeCharacters("\n" + "  ".repeat(depth));
    }

    /** XML knows no control characters and no halves of surrogate pairs, not even escaped. */
    private static String allowed(String text) {
        return text.codePoints()
                .map(c -> isAllowed(c) ? c : 0xfffd)
                .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append)
                .toString();
    }

    private static boolean isAllowed(int c) {
        return c >= 0x20 && c < 0xd800
                || c == '\t'
                || c == '\n'
                || c == '\r'
                || c >= 0xe000 && c != 0xfffe && c != 0xffff;
    }
}

package org.dronewatch.report.map;

import java.io.StringReader;
import java.nio.file.Path;
import javax.xml.XMLConstants;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.transform.stream.StreamSource;
import javax.xml.validation.Schema;
import javax.xml.validation.SchemaFactory;
import org.w3c.dom.ls.DOMImplementationLS;
import org.w3c.dom.ls.LSInput;

/** OGC's schema of KML 2.2, as JAK (Java API for KML) brings it along; nothing is fetched from anywhere. */
final class KmlSchema {
    private static final String FOLDER = "/schema/ogckml/";

    /** The schema of addresses is not in JAK, and no map has addresses. */
    private static final String ADDRESSES =
            """
            <schema xmlns="http://www.w3.org/2001/XMLSchema" targetNamespace="urn:oasis:names:tc:ciq:xsdschema:xAL:2.0">
              <element name="AddressDetails"/>
            </schema>
            """;

    private final Schema schema;

    KmlSchema() throws Exception {
        SchemaFactory factory = SchemaFactory.newInstance(XMLConstants.W3C_XML_SCHEMA_NS_URI);
        DOMImplementationLS inputs = (DOMImplementationLS) DocumentBuilderFactory.newInstance()
                .newDocumentBuilder()
                .getDOMImplementation()
                .getFeature("LS", "3.0");
        factory.setResourceResolver((type, namespace, publicId, systemId, base) -> {
            LSInput input = inputs.createLSInput();
            input.setSystemId(systemId);
            if (systemId.equals("atom-author-link.xsd")) {
                input.setByteStream(KmlSchema.class.getResourceAsStream(FOLDER + systemId));
            } else {
                input.setCharacterStream(new StringReader(ADDRESSES));
            }
            return input;
        });
        schema = factory.newSchema(new StreamSource(KmlSchema.class.getResourceAsStream(FOLDER + "ogckml22.xsd")));
    }

    /** Refuses a file that is not as the schema wants it. */
    void validate(Path file) throws Exception {
        schema.newValidator().validate(new StreamSource(file.toFile()));
    }
}

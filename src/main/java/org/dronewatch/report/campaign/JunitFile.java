package org.dronewatch.report.campaign;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import javax.xml.stream.XMLOutputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.CampaignRun;
import org.dronewatch.campaign.Expectation;
import org.dronewatch.campaign.Stopping;
import org.dronewatch.campaign.outcome.CampaignSummary;
import org.dronewatch.campaign.outcome.CaseResult;

/**
 * A campaign as test results in JUnit's XML format: a suite of its expectations, and one of the cases of each variant,
 * in which those that could not be run fail.
 */
final class JunitFile {
    private static final String FAILURE = "failure";

    private final CampaignPlan plan;
    private final CampaignSummary summary;
    private final CampaignRun.Chunks chunks;

    JunitFile(CampaignPlan plan, CampaignSummary summary, CampaignRun.Chunks chunks) {
        this.plan = plan;
        this.summary = summary;
        this.chunks = chunks;
    }

    void write(OutputStream stream) throws IOException {
        try {
            XMLStreamWriter xml = XMLOutputFactory.newInstance().createXMLStreamWriter(stream, "UTF-8");
            xml.writeStartDocument(StandardCharsets.UTF_8.name(), "1.0");
            line(xml);
            xml.writeStartElement("testsuites");
            line(xml);
            List<Expectation> expected = plan.settings().expect();
            if (!expected.isEmpty()) {
                long missed = expected.stream()
                        .filter(one -> !one.isMet(plan, summary))
                        .count();
                begin(xml, "expectations", expected.size(), missed);
                for (Expectation one : expected) {
                    String failure = one.isMet(plan, summary) ? null : CampaignWords.missed(plan, one, summary);
                    add(xml, one.variantIn(plan), name(one), failure);
                }
                end(xml);
            }
            for (String variant : plan.variants()) {
                begin(
                        xml,
                        variant,
                        summary.variants().get(variant).cases(),
                        summary.variants().get(variant).failed());
                addCases(xml, variant);
                end(xml);
            }
            xml.writeEndElement();
            line(xml);
            xml.writeEndDocument();
            xml.flush();
        } catch (XMLStreamException e) {
            throw new IOException(e.getMessage(), e);
        }
    }

    private void addCases(XMLStreamWriter xml, String variant) throws XMLStreamException {
        Stopping stopping = new Stopping(plan);
        int variants = plan.variants().size();
        for (int chunk = 0; chunk < CampaignRun.chunks(plan) && !stopping.isReached(); chunk++) {
            List<CaseResult> results = chunks.find(chunk).orElse(List.of());
            int cases = stopping.add(results);
            for (CaseResult result : results.subList(0, cases * variants)) {
                if (result.variant().equals(variant)) {
                    add(xml, variant, "case " + result.number(), result.error().orElse(null));
                }
            }
        }
    }

    private static void begin(XMLStreamWriter xml, String name, long tests, long failures) throws XMLStreamException {
        xml.writeStartElement("testsuite");
        xml.writeAttribute("name", name);
        xml.writeAttribute("tests", Long.toString(tests));
        xml.writeAttribute("failures", Long.toString(failures));
        line(xml);
    }

    private static void end(XMLStreamWriter xml) throws XMLStreamException {
        xml.writeEndElement();
        line(xml);
    }

    private static void add(XMLStreamWriter xml, String group, String name, String failure) throws XMLStreamException {
        xml.writeStartElement("testcase");
        xml.writeAttribute("classname", group);
        xml.writeAttribute("name", name);
        if (failure != null) {
            xml.writeStartElement(FAILURE);
            xml.writeAttribute("message", failure);
            xml.writeEndElement();
        }
        end(xml);
    }

    private static void line(XMLStreamWriter xml) throws XMLStreamException {
        xml.writeCharacters("\n");
    }

    private static String name(Expectation one) {
        return one.of().name().toLowerCase(Locale.ROOT) + " at least " + one.low();
    }
}

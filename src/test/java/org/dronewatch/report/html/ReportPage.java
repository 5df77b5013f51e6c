package org.dronewatch.report.html;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import javax.xml.parsers.DocumentBuilderFactory;
import org.dronewatch.report.html.run.HtmlReport;
import org.dronewatch.report.html.run.Looks;
import org.dronewatch.report.html.run.RunView;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.w3c.dom.Document;
import org.w3c.dom.NodeList;
import org.xml.sax.SAXException;

/** Reports of scenes, and what stands in them. */
public final class ReportPage {
    private ReportPage() {}

    public static String report(Scene scene, List<Figure> figures) throws IOException {
        SceneRunner runner = new SceneRunner(scene);
        Looks looks = new Looks();
        SceneResult result = runner.listener(looks).run();
        ByteArrayOutputStream page = new ByteArrayOutputStream();
        new HtmlReport(
                        result,
                        looks,
                        run -> new RunView(runner.stage(run.settings()), figures),
                        List.of(),
                        Map.of("program", "dronewatch <1>"))
                .write(page);
        return page.toString(StandardCharsets.UTF_8);
    }

    public static Document parsed(String page) throws IOException {
        try {
            return DocumentBuilderFactory.newInstance()
                    .newDocumentBuilder()
                    .parse(new ByteArrayInputStream(page.getBytes(StandardCharsets.UTF_8)));
        } catch (SAXException | javax.xml.parsers.ParserConfigurationException e) {
            throw new AssertionError(e);
        }
    }

    public static List<String> texts(Document page, String tag) {
        NodeList nodes = page.getElementsByTagName(tag);
        List<String> texts = new ArrayList<>();
        for (int i = 0; i < nodes.getLength(); i++) {
            texts.add(nodes.item(i).getTextContent().strip());
        }
        return texts;
    }
}

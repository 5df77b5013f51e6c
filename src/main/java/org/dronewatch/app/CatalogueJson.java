package org.dronewatch.app;

import java.util.Locale;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.catalog.CatalogEntry;
import org.dronewatch.catalog.CatalogTexts;
import org.dronewatch.catalog.Positioners;
import org.dronewatch.catalog.SensorSystem;
import org.dronewatch.mesh.io.MeshReaders;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.scenes.PackagedScene;
import org.dronewatch.setting.FoundKind;
import org.dronewatch.setting.KindRegistry;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** The JSON that {@code list} prints for programs. */
final class CatalogueJson {
    private CatalogueJson() {}

    /** The packaged scenes, and all entries of the catalogue. */
    static ObjectNode all() {
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        ArrayNode scenes = root.putArray("scenes");
        for (PackagedScene scene : PackagedScene.all()) {
            scenes.addObject().put("name", scene.name()).put("summary", scene.summary());
        }
        ArrayNode sensors = root.putArray("sensors");
        for (String name : Catalog.packagedNames()) {
            add(sensors.addObject(), name, Catalog.packaged().entry(name).orElseThrow());
        }
        ArrayNode systems = root.putArray("systems");
        for (String name : Catalog.systemNames()) {
            SensorSystem system = Catalog.system(name).orElseThrow();
            ObjectNode node = systems.addObject().put("name", name).put("title", system.title());
            ObjectNode parts = node.putObject("sensors");
            system.sensors()
                    .forEach((id, part) -> parts.put(id, part.text("use").orElse(null)));
        }
        ArrayNode positioners = root.putArray("positioners");
        for (String name : Positioners.packagedNames()) {
            CatalogEntry entry = new Positioners().entry(name).orElseThrow();
            positioners
                    .addObject()
                    .put("name", name)
                    .put("title", entry.title())
                    .put("coverage", entry.coverage());
        }
        return root;
    }

    private static void add(ObjectNode node, String name, CatalogEntry entry) {
        node.put("name", name);
        node.put("kind", entry.kind());
        node.put("title", entry.title());
        ArrayNode ranges = node.putArray("ranges");
        entry.ranges().forEach(range -> ranges.addObject()
                .put("distance_m", Numbers.rounded(range.distance()))
                .put("target", range.target()));
        node.put("coverage", entry.coverage());
        node.put("basis", entry.basis().name().toLowerCase(Locale.ROOT));
        node.put("price", entry.price().orElse(null));
    }

    /** One entry, as it is written in the catalogue. */
    static ObjectNode entry(String name) {
        return JsonNodeFactory.instance.objectNode().put("name", name).put("yaml", CatalogTexts.of(name));
    }

    /** The kinds that scene files choose by name, and the model files that can be read. */
    static ObjectNode kinds() {
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        ArrayNode kinds = root.putArray("kinds");
        for (FoundKind found : KindRegistry.found().all()) {
            kinds.addObject()
                    .put("type", ListCommand.typeInWords(found.kind().type()))
                    .put("name", found.kind().name())
                    .put("summary", found.kind().summary())
                    .put("origin", found.origin());
        }
        ArrayNode readers = root.putArray("model_files");
        MeshReaders.found().byExtension().forEach((extension, reader) -> readers.addObject()
                .put("extension", extension)
                .put("summary", reader.summary())
                .put("origin", FoundKind.originOf(reader.getClass())));
        return root;
    }
}

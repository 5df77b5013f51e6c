package org.dronewatch.catalog;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Spelling;

/** The files of packaged sensors, systems and positioners, as templates for others. */
public final class CatalogTexts {
    private CatalogTexts() {}

    /**
     * The file of an entry, with its source, its assumptions and its settings.
     *
     * @param name name of a sensor, a system or a positioner
     * @throws InputException when there is none of that name
     */
    public static String of(String name) {
        Map<String, String> folders = new LinkedHashMap<>();
        Catalog.packagedNames().forEach(sensor -> folders.put(sensor, ""));
        Catalog.systemNames().forEach(system -> folders.put(system, "system/"));
        Positioners.packagedNames().forEach(positioner -> folders.put(positioner, "positioner/"));
        if (!folders.containsKey(name)) {
            throw new InputException("no entry '" + PlainText.value(name) + "' in the catalogue; "
                    + Spelling.closestMatches(name, folders.keySet()));
        }
        String file = folders.get(name) + name + ".yaml";
        try (InputStream in = CatalogTexts.class.getResourceAsStream(file)) {
            if (in == null) {
                throw new IllegalStateException("resource " + file + " is missing");
            }
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new IllegalStateException("resource " + file + " cannot be read", e);
        }
    }
}

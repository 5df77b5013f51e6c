package org.dronewatch.buildings.io;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.geo.MapExtent;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.input.FileHash;
import tools.jackson.databind.JsonNode;

/**
 * Reads buildings and their parts from CityJSON 1.1 and 2.0: solids and surfaces of the most detailed level up to 2,
 * without openings such as windows, which the third level adds.
 */
final class CityJsonFile {
    /** Levels of detail from this one up have windows and rooms. */
    private static final double TOO_DETAILED = 3.0;

    private final String file;
    private final JsonNode root;
    private final double[] vertices;
    private final List<CityModel.Solid> solids = new ArrayList<>();
    private final Map<String, Integer> leftOut = new LinkedHashMap<>();

    private CityJsonFile(String file, JsonNode root) {
        this.file = file;
        this.root = root;
        this.vertices = vertices();
    }

    /**
     * Reads a file.
     *
     * @param file its name, for messages
     * @param hash hash of the file
     * @throws InputException with a one-line message when something in it is invalid
     */
    static MapFeatures read(String file, JsonNode root, FileHash hash) {
        String version = root.path("version").asString("");
        if (!version.startsWith("1.") && !version.startsWith("2.")) {
            throw new InputException(file + ": CityJSON version '" + PlainText.value(version)
                    + "' must be 1.0 to 2.0; 'cjio " + file + " upgrade' converts older files");
        }
        CityJsonFile reader = new CityJsonFile(file, root);
        root.path("CityObjects").properties().forEach(one -> reader.object(one.getKey(), one.getValue()));
        return new MapFeatures(
                List.of(),
                Optional.of(new CityModel(reader.vertices, reader.solids)),
                MapLand.NONE,
                reader.leftOut,
                "CityJSON",
                reader.system(),
                hash);
    }

    private MapSystem system() {
        String text = root.path("metadata").path("referenceSystem").asString("");
        MapExtent.Collector extent = new MapExtent.Collector();
        solids.stream()
                .flatMap(solid -> solid.surfaces().stream())
                .flatMap(List::stream)
                .flatMapToInt(Arrays::stream)
                .forEach(vertex -> extent.add(vertices[3 * vertex], vertices[3 * vertex + 1]));
        return new MapSystem(
                MapSystem.Rule.STATED,
                Optional.of(text).filter(any -> !text.isEmpty()),
                "metadata.referenceSystem",
                extent.extent(),
                Optional.empty());
    }

    private double[] vertices() {
        JsonNode all = root.path("vertices");
        double[] found = new double[3 * all.size()];
        JsonNode scale = root.path("transform").path("scale");
        JsonNode translate = root.path("transform").path("translate");
        for (int i = 0; i < all.size(); i++) {
            for (int axis = 0; axis < 3; axis++) {
                double value = number(all.get(i).path(axis), "vertices[" + i + "]");
                found[3 * i + axis] = scale.isMissingNode()
                        ? value
                        : value * number(scale.path(axis), "transform.scale")
                                + number(translate.path(axis), "transform.translate");
            }
        }
        return found;
    }

    private double number(JsonNode node, String where) {
        if (!node.isNumber() || !Double.isFinite(node.doubleValue())) {
            throw new InputException(
                    file + ": " + where + " has '" + PlainText.value(node) + "' but must have three numbers");
        }
        return node.doubleValue();
    }

    private void object(String id, JsonNode object) {
        String type = object.path("type").asString("");
        if (!type.equals("Building") && !type.equals("BuildingPart")) {
            leftOut.merge(type.isEmpty() ? "object without a type" : type, 1, Integer::sum);
            return;
        }
        JsonNode best = null;
        double detail = -1.0;
        for (JsonNode geometry : object.path("geometry")) {
            String lod = geometry.path("lod").asString("");
            double level = lod.matches("\\d(\\.\\d)?") ? Double.parseDouble(lod) : 0.0;
            boolean isVolume = !geometry.path("type").asString("").startsWith("MultiLine")
                    && !geometry.path("type").asString("").startsWith("MultiPoint");
            if (isVolume && level >= 1.0 && level < TOO_DETAILED && level > detail) {
                best = geometry;
                detail = level;
            }
        }
        if (best != null) {
            geometry(id, best);
        } else if (object.path("children").isEmpty()) {
            leftOut.merge("building without a solid at level of detail 1 or 2", 1, Integer::sum);
        }
    }

    private void geometry(String id, JsonNode geometry) {
        JsonNode boundaries = geometry.path("boundaries");
        switch (geometry.path("type").asString("")) {
            // The first shell is the outer one; others are voids inside.
            case "Solid" -> surfaces(id, boundaries.path(0));
            case "MultiSolid", "CompositeSolid" -> boundaries.forEach(solid -> surfaces(id, solid.path(0)));
            case "MultiSurface", "CompositeSurface" -> surfaces(id, boundaries);
            default ->
                throw new InputException(file + ": " + PlainText.value(id) + ": geometry type '"
                        + PlainText.value(geometry.path("type").asString("")) + "' must be Solid or MultiSurface");
        }
    }

    private void surfaces(String id, JsonNode shell) {
        List<List<int[]>> surfaces = new ArrayList<>();
        for (JsonNode surface : shell) {
            List<int[]> rings = new ArrayList<>();
            for (JsonNode ring : surface) {
                rings.add(ring(id, ring));
            }
            if (!rings.isEmpty()) {
                surfaces.add(List.copyOf(rings));
            }
        }
        if (!surfaces.isEmpty()) {
            solids.add(new CityModel.Solid(id, surfaces));
        }
    }

    private int[] ring(String id, JsonNode ring) {
        int[] corners = new int[ring.size()];
        for (int i = 0; i < corners.length; i++) {
            JsonNode corner = ring.get(i);
            int number = corner.isInt() ? corner.intValue() : -1;
            if (number < 0 || 3 * number >= vertices.length) {
                throw new InputException(file + ": " + PlainText.value(id) + ": vertex '" + PlainText.value(corner)
                        + "' must be 0 to " + (vertices.length / 3 - 1));
            }
            corners[i] = number;
        }
        return corners;
    }
}

package org.dronewatch.mesh.io;

import java.io.IOException;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.CancellationException;
import java.util.regex.Pattern;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.input.FileHash;
import tools.jackson.databind.JsonNode;

/** The nodes of a glTF file with their transforms, and the triangles of their meshes. */
final class GltfScene {
    private static final int MOST_DEPTH = 256;
    private static final int TRIANGLES = 4;
    private static final int STRIP = 5;
    private static final int FAN = 6;
    /** Bytes of an entry of a map from number to number. */
    private static final int ENTRY = 120;

    private static final String UNNAMED = "default";
    private static final Set<String> PACKED =
            Set.of("KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression");

    /** Extensions that change nothing but the looks of a surface, or are read as the format itself is. */
    private static final Pattern HARMLESS =
            Pattern.compile("KHR_mesh_quantization|KHR_materials_.*|(KHR|EXT)_texture_.*|KHR_lights_.*|KHR_xmp.*");

    private static final String INSTANCES = "EXT_mesh_gpu_instancing";

    private static final double[] IDENTITY = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

    private final ModelFile file;
    private final JsonNode root;
    private final ModelCollector collector;
    private final GltfBuffers buffers;
    private final Map<String, Integer> skipped = new TreeMap<>();
    private final BitSet reached = new BitSet();

    GltfScene(ModelFile file, JsonNode root, byte[] binary, ModelCollector collector) throws IOException {
        this.file = file;
        this.root = root;
        this.collector = collector;
        if (!root.path("asset").path("version").asString("").startsWith("2.")) {
            throw new InputException(file.name() + ": asset.version is '"
                    + PlainText.value(root.path("asset").path("version").asString(""))
                    + "' but must be 2.0: not glTF");
        }
        for (JsonNode extension : root.path("extensionsRequired")) {
            if (PACKED.contains(extension.asString(""))) {
                throw new InputException(file.name() + ": is compressed with " + extension.asString()
                        + ": 'gltf-transform copy' writes an uncompressed file");
            }
            if (!HARMLESS.matcher(extension.asString("")).matches()) {
                throw new InputException(file.name() + ": requires the extension '"
                        + PlainText.value(extension.asString("")) + "', which is not supported");
            }
        }
        this.buffers = new GltfBuffers(file, root, binary, collector.budget());
    }

    /** Everything that the scene has. */
    LoadedModel read() {
        JsonNode nodes = root.path("nodes");
        JsonNode scene = root.path("scenes").path(root.path("scene").asInt(0));
        if (!scene.isMissingNode()) {
            scene.path("nodes").forEach(node -> node(node.asInt(-1), IDENTITY, 0));
        } else if (root.has("scene")) {
            throw new InputException(
                    file.name() + ": scene " + root.path("scene").asInt(-1) + " does not exist");
        } else {
            BitSet children = new BitSet();
            nodes.forEach(node -> node.path("children").forEach(child -> {
                int number = child.asInt(-1);
                if (number >= 0 && number < nodes.size()) {
                    children.set(number);
                }
            }));
            for (int i = children.nextClearBit(0); i < nodes.size(); i = children.nextClearBit(i + 1)) {
                node(i, IDENTITY, 0);
            }
        }
        skipped.forEach((what, count) -> collector.warn(file.name() + ": skipped " + what + " (" + count + ")"));
        LoadedModel model = collector.toModel();
        List<FileHash> files = new ArrayList<>(model.files());
        files.addAll(buffers.files());
        return new LoadedModel(
                model.name(), model.mesh(), model.dropped(), model.skipped(), model.colours(), files, model.warnings());
    }

    private void node(int number, double[] parent, int depth) {
        JsonNode node = root.path("nodes").path(number);
        if (node.isMissingNode() || depth > MOST_DEPTH) {
            throw new InputException(file.name()
                    + (node.isMissingNode()
                            ? ": node " + number + " does not exist"
                            : ": nodes are nested more than " + MOST_DEPTH + " deep"));
        }
        // Nodes are trees (glTF 2.0, section 3.5.2). Forty nodes, each twice the child of the one before, would be
        // 2^40.
        if (reached.get(number)) {
            throw new InputException(file.name() + ": node " + number + " is a child twice, or its own ancestor");
        }
        reached.set(number);
        if (node.has("skin")) {
            skipped.merge("skins", 1, Integer::sum);
        }
        if (node.path("extensions").has(INSTANCES)) {
            skipped.merge(INSTANCES + " lists of mesh instances", 1, Integer::sum);
        }
        double[] matrix = matrix(node, parent);
        mesh(node, matrix);
        node.path("children").forEach(child -> node(child.asInt(-1), matrix, depth + 1));
    }

    /** The transform of a node after that of its parent; columns one after the other, as in the file. */
    private double[] matrix(JsonNode node, double[] parent) {
        double[] own = node.has("matrix")
                ? numbers(node.path("matrix"), IDENTITY)
                : placed(
                        numbers(node.path("translation"), new double[3]),
                        numbers(node.path("rotation"), new double[] {0, 0, 0, 1}),
                        numbers(node.path("scale"), new double[] {1, 1, 1}));
        double[] product = new double[16];
        for (int column = 0; column < 4; column++) {
            for (int row = 0; row < 4; row++) {
                for (int k = 0; k < 4; k++) {
                    product[4 * column + row] += parent[4 * k + row] * own[4 * column + k];
                }
            }
        }
        return product;
    }

    private double[] numbers(JsonNode array, double[] otherwise) {
        if (array.isMissingNode()) {
            return otherwise;
        }
        double[] numbers = new double[otherwise.length];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = array.path(i).isNumber() ? array.path(i).doubleValue() : Double.NaN;
            if (!Double.isFinite(numbers[i])) {
                throw new InputException(file.name() + ": a transform of a node needs " + numbers.length + " numbers");
            }
        }
        return numbers;
    }

    /** Scaled, turned by a unit quaternion x, y, z, w, and moved. */
    private static double[] placed(double[] move, double[] turn, double[] scale) {
        double x = turn[0];
        double y = turn[1];
        double z = turn[2];
        double w = turn[3];
        return new double[] {
            scale[0] * (1 - 2 * (y * y + z * z)),
            scale[0] * 2 * (x * y + z * w),
            scale[0] * 2 * (x * z - y * w),
            0,
            scale[1] * 2 * (x * y - z * w),
            scale[1] * (1 - 2 * (x * x + z * z)),
            scale[1] * 2 * (y * z + x * w),
            0,
            scale[2] * 2 * (x * z + y * w),
            scale[2] * 2 * (y * z - x * w),
            scale[2] * (1 - 2 * (x * x + y * y)),
            0,
            move[0],
            move[1],
            move[2],
            1
        };
    }

    private void mesh(JsonNode node, double[] matrix) {
        if (!node.has("mesh")) {
            return;
        }
        JsonNode mesh = root.path("meshes").path(node.path("mesh").asInt(-1));
        if (mesh.isMissingNode()) {
            throw new InputException(file.name() + ": mesh " + node.path("mesh").asInt(-1) + " does not exist");
        }
        mesh.path("primitives").forEach(primitive -> primitive(primitive, matrix));
    }

    private void primitive(JsonNode primitive, double[] matrix) {
        int mode = primitive.path("mode").asInt(TRIANGLES);
        if (mode < TRIANGLES || mode > FAN) {
            skipped.merge("primitives of points or lines", 1, Integer::sum);
            return;
        }
        if (!primitive.path("attributes").has("POSITION")) {
            throw new InputException(file.name() + ": a primitive has no POSITION");
        }
        GltfBuffers.Accessor positions =
                buffers.accessor(primitive.path("attributes").path("POSITION").asInt(-1), "VEC3", 3);
        int[] corners = corners(primitive, positions, matrix);
        if (mode == TRIANGLES && corners.length % 3 != 0) {
            throw new InputException(
                    file.name() + ": a primitive of " + corners.length + " corners, not a whole number of triangles");
        }
        String material = material(primitive);
        // A transform that mirrors turns triangles inside out.
        boolean isMirrored = determinant(matrix) < 0.0;
        int step = mode == TRIANGLES ? 3 : 1;
        for (int i = 0; i + 2 < corners.length; i += step) {
            if (Thread.currentThread().isInterrupted()) {
                throw new CancellationException("interrupted while a model was read");
            }
            int a = mode == FAN ? 0 : i;
            boolean isTurned = isMirrored ^ (mode == STRIP && i % 2 != 0);
            int b = isTurned ? i + 2 : i + 1;
            int c = isTurned ? i + 1 : i + 2;
            collector.addFace(material, corners[a], corners[b], corners[c]);
        }
    }

    private static double along(double[] matrix, int row, double x, double y, double z) {
        return matrix[row] * x + matrix[4 + row] * y + matrix[8 + row] * z + matrix[12 + row];
    }

    private static double determinant(double[] m) {
        return m[0] * (m[5] * m[10] - m[9] * m[6])
                - m[4] * (m[1] * m[10] - m[9] * m[2])
                + m[8] * (m[1] * m[6] - m[5] * m[2]);
    }

    /**
     * The vertices of the corners of a primitive, added to the model. Many primitives may take a few each from the same
     * positions: the effort is proportional to the number of corners, not to the number of positions in the file.
     */
    private int[] corners(JsonNode primitive, GltfBuffers.Accessor positions, double[] matrix) {
        if (!primitive.has("indices")) {
            collector.budget().check((long) Integer.BYTES * positions.count());
            int[] corners = new int[positions.count()];
            for (int i = 0; i < corners.length; i++) {
                corners[i] = vertex(positions, i, matrix);
            }
            return corners;
        }
        int number = primitive.path("indices").asInt(-1);
        GltfBuffers.Accessor indices = buffers.accessor(number, "SCALAR", 1);
        collector.budget().check((long) Integer.BYTES * indices.count());
        int[] corners = new int[indices.count()];
        Map<Integer, Integer> added = new HashMap<>();
        for (int i = 0; i < corners.length; i++) {
            double index = indices.at(i, 0);
            if (!(index >= 0.0 && index < positions.count())) {
                throw new InputException(file.name() + ": accessor " + number + ": vertex index " + (long) index
                        + " must be 0 to " + (positions.count() - 1));
            }
            corners[i] = added.computeIfAbsent((int) index, at -> vertex(positions, at, matrix));
            collector.budget().check((long) ENTRY * added.size());
        }
        return corners;
    }

    private int vertex(GltfBuffers.Accessor positions, int number, double[] matrix) {
        double x = positions.at(number, 0);
        double y = positions.at(number, 1);
        double z = positions.at(number, 2);
        return collector.addVertex(along(matrix, 0, x, y, z), along(matrix, 1, x, y, z), along(matrix, 2, x, y, z));
    }

    private String material(JsonNode primitive) {
        if (!primitive.has("material")) {
            return UNNAMED;
        }
        int number = primitive.path("material").asInt(-1);
        JsonNode material = root.path("materials").path(number);
        if (material.isMissingNode()) {
            throw new InputException(file.name() + ": material " + number + " does not exist");
        }
        String name = material.path("name").asString("");
        String used = name.isBlank() ? "material" + number : name;
        JsonNode colour = material.path("pbrMetallicRoughness").path("baseColorFactor");
        if (colour.isArray()) {
            int rgb = 0;
            for (int channel = 0; channel < 3; channel++) {
                rgb = rgb << 8 | encoded(colour.path(channel).asDouble(1.0));
            }
            collector.setColour(used, rgb);
        }
        return used;
    }

    /** A linear fraction of light as it is shown on a screen (IEC 61966-2-1). */
    private static int encoded(double linear) {
        double share = Math.max(0.0, Math.min(1.0, linear));
        double shown = share <= 0.0031308 ? 12.92 * share : 1.055 * Math.pow(share, 1.0 / 2.4) - 0.055;
        return (int) (255.0 * shown + 0.5);
    }
}

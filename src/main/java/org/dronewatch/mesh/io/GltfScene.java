package org.dronewatch.mesh.io;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.CancellationException;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.file.FileHash;
import tools.jackson.databind.JsonNode;

/** The nodes of a glTF file with their transforms, and the triangles of their meshes. */
final class GltfScene {
    private static final int MOST_DEPTH = 256;
    private static final int TRIANGLES = 4;
    private static final int STRIP = 5;
    private static final int FAN = 6;
    private static final String UNNAMED = "default";
    private static final Set<String> PACKED = Set.of("KHR_draco_mesh_compression", "EXT_meshopt_compression");

    private static final double[] IDENTITY = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

    private final ModelFile file;
    private final JsonNode root;
    private final ModelCollector collector;
    private final GltfBuffers buffers;
    private final Map<String, Integer> skipped = new TreeMap<>();

    GltfScene(ModelFile file, JsonNode root, byte[] binary, ModelCollector collector) throws IOException {
        this.file = file;
        this.root = root;
        this.collector = collector;
        if (!root.path("asset").path("version").asString("").startsWith("2.")) {
            throw new InputException(file.name() + ": asset.version is '"
                    + PlainText.value(root.path("asset").path("version").asString(""))
                    + "', must be 2.0: not glTF");
        }
        for (JsonNode extension : root.path("extensionsRequired")) {
            if (PACKED.contains(extension.asString(""))) {
                throw new InputException(file.name() + ": is packed by " + extension.asString()
                        + ": 'gltf-transform copy' writes a file without");
            }
        }
        this.buffers = new GltfBuffers(file, root, binary);
    }

    /** Everything that the scene has. */
    LoadedModel read() {
        JsonNode nodes = root.path("nodes");
        JsonNode scene = root.path("scenes").path(root.path("scene").asInt(0));
        if (scene.isMissingNode()) {
            for (int i = 0; i < nodes.size(); i++) {
                mesh(nodes.get(i), matrix(nodes.get(i), IDENTITY));
            }
        } else {
            for (JsonNode node : scene.path("nodes")) {
                node(node.asInt(-1), IDENTITY, 0);
            }
        }
        skipped.forEach((what, count) -> collector.warn(file.name() + ": skipped " + count + " " + what));
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
        double[] positions =
                buffers.values(primitive.path("attributes").path("POSITION").asInt(-1), "VEC3", 3);
        int base = 0;
        for (int i = 0; i < positions.length; i += 3) {
            int added = collector.addVertex(
                    along(matrix, 0, positions, i), along(matrix, 1, positions, i), along(matrix, 2, positions, i));
            base = i == 0 ? added : base;
        }
        int[] corners = corners(primitive, positions.length / 3);
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
            collector.addFace(material, base + corners[a], base + corners[b], base + corners[c]);
        }
    }

    private static double along(double[] matrix, int row, double[] positions, int at) {
        return matrix[row] * positions[at]
                + matrix[4 + row] * positions[at + 1]
                + matrix[8 + row] * positions[at + 2]
                + matrix[12 + row];
    }

    private static double determinant(double[] m) {
        return m[0] * (m[5] * m[10] - m[9] * m[6])
                - m[4] * (m[1] * m[10] - m[9] * m[2])
                + m[8] * (m[1] * m[6] - m[5] * m[2]);
    }

    private int[] corners(JsonNode primitive, int vertices) {
        if (!primitive.has("indices")) {
            int[] corners = new int[vertices];
            for (int i = 0; i < vertices; i++) {
                corners[i] = i;
            }
            return corners;
        }
        double[] indices = buffers.values(primitive.path("indices").asInt(-1), "SCALAR", 1);
        int[] corners = new int[indices.length];
        for (int i = 0; i < corners.length; i++) {
            if (!(indices[i] >= 0.0 && indices[i] < vertices)) {
                throw new InputException(
                        file.name() + ": vertex index " + (long) indices[i] + " must be 0 to " + (vertices - 1));
            }
            corners[i] = (int) indices[i];
        }
        return corners;
    }

    private String material(JsonNode primitive) {
        if (!primitive.has("material")) {
            return UNNAMED;
        }
        int number = primitive.path("material").asInt(-1);
        JsonNode material = root.path("materials").path(number);
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

    /** A linear share of light as it is shown on a screen (IEC 61966-2-1). */
    private static int encoded(double linear) {
        double share = Math.max(0.0, Math.min(1.0, linear));
        double shown = share <= 0.0031308 ? 12.92 * share : 1.055 * Math.pow(share, 1.0 / 2.4) - 0.055;
        return (int) (255.0 * shown + 0.5);
    }
}

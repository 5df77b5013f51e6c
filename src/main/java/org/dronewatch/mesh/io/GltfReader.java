package org.dronewatch.mesh.io;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.Set;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.input.HeapBudget;
import org.dronewatch.setting.input.JsonText;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Reads glTF 2.0, as one file (.glb) or as JSON (.gltf) with its buffers: the nodes of its scene with their transforms,
 * their triangles, and the names and base colours of materials. Textures, animations, skins and points have no effect.
 */
public final class GltfReader implements MeshReader {
    private static final byte[] MAGIC = {'g', 'l', 'T', 'F'};
    private static final int JSON_CHUNK = 0x4E4F534A;
    private static final int BINARY_CHUNK = 0x004E4942;
    private static final int MOST_JSON = 1 << 28;

    /** Creates a reader; it has no state. */
    public GltfReader() {
        // For the service loader.
    }

    @Override
    public Set<String> extensions() {
        return Set.of("glb", "gltf");
    }

    @Override
    public String summary() {
        return "glTF 2.0, as one file or with buffers next to it";
    }

    @Override
    public LoadedModel read(ModelFile file, ModelSettings settings) {
        try {
            ModelCollector collector = new ModelCollector(file, settings);
            Parts parts = parts(file, collector.budget());
            return new GltfScene(file, parts.root(), parts.binary(), collector).read();
        } catch (EOFException e) {
            throw new InputException(file.name() + ": ends too early: it is truncated or damaged", e);
        } catch (IOException e) {
            throw new InputException("model file " + file.name() + " cannot be read: " + e.getMessage(), e);
        }
    }

    private record Parts(JsonNode root, byte[] binary) {}

    private static Parts parts(ModelFile file, HeapBudget budget) throws IOException {
        try (DataInputStream in = new DataInputStream(file.open())) {
            in.mark(MAGIC.length);
            if (!Arrays.equals(in.readNBytes(MAGIC.length), MAGIC)) {
                in.reset();
                budget.take(2 * file.size());
                return new Parts(json(file, bounded(file, in), budget), new byte[0]);
            }
            int version = Integer.reverseBytes(in.readInt());
            if (version != 2) {
                throw new InputException(file.name() + ": glTF version " + version + " must be 2");
            }
            in.readInt();
            JsonNode root = null;
            byte[] binary = {};
            while (root == null || binary.length == 0) {
                int length = in.read();
                if (length < 0) {
                    break;
                }
                length |= in.readUnsignedByte() << 8 | in.readUnsignedByte() << 16 | in.readUnsignedByte() << 24;
                int type = Integer.reverseBytes(in.readInt());
                if (length < 0 || length > file.size()) {
                    throw new InputException(file.name() + ": a chunk of " + Integer.toUnsignedLong(length)
                            + " bytes in a file of " + file.size());
                }
                // While it is read, there are two copies of it.
                budget.take(2L * length);
                byte[] bytes = in.readNBytes(length);
                if (bytes.length < length) {
                    throw new EOFException();
                }
                if (type == JSON_CHUNK) {
                    root = json(file, bytes, budget);
                } else if (type == BINARY_CHUNK) {
                    binary = bytes;
                }
            }
            if (root == null) {
                throw new InputException(file.name() + ": has no JSON chunk");
            }
            return new Parts(root, binary);
        }
    }

    private static byte[] bounded(ModelFile file, InputStream in) throws IOException {
        byte[] bytes = in.readNBytes(MOST_JSON + 1);
        if (bytes.length > MOST_JSON) {
            throw new InputException(file.name() + ": more than " + MOST_JSON + " bytes of JSON");
        }
        return bytes;
    }

    private static JsonNode json(ModelFile file, byte[] bytes, HeapBudget budget) {
        budget.take(JsonText.memory(bytes));
        try {
            return JsonMapper.shared().readTree(bytes);
        } catch (JacksonException e) {
            throw new InputException(
                    file.name() + ": not glTF: " + PlainText.line(String.valueOf(e.getOriginalMessage())), e);
        }
    }
}

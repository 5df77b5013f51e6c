package org.dronewatch.buildings.io;

import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/**
 * Reads the binary format of OpenStreetMap (PBF), in which texts are given by their numbers, and coordinates as
 * differences in nanodegrees.
 */
final class OsmPbf {
    private static final Set<String> KNOWN = Set.of("OsmSchema-V0.6", "DenseNodes");

    /** Coordinates count nanodegrees. */
    private static final double PER_DEGREE = 1e9;

    private static final int WAY = 1;

    private final OsmElements target;
    private PbfStrings strings = PbfStrings.NONE;
    private long granularity;
    private long latitudeOffset;
    private long longitudeOffset;

    private OsmPbf(OsmElements target) {
        this.target = target;
    }

    /**
     * Reads a file to its end.
     *
     * @param file its name, for messages
     * @throws InputException with a one-line message when it is damaged or uses what is not known
     * @throws IOException when it ends too early or is damaged
     */
    static void read(String file, InputStream in, OsmElements target) throws IOException {
        PbfBlocks blocks = new PbfBlocks(file, in);
        OsmPbf reader = new OsmPbf(target);
        while (blocks.next()) {
            switch (blocks.type()) {
                case "OSMHeader" -> checkFeatures(file, blocks.unpacked());
                case "OSMData" -> reader.block(blocks.unpacked());
                default -> {
                    // The format asks readers to skip what they do not know.
                }
            }
        }
    }

    private static void checkFeatures(String file, byte[] header) throws IOException {
        for (ProtoReader reader = new ProtoReader(header); reader.next(); ) {
            if (reader.field() == 4) {
                String feature = reader.text();
                if (!KNOWN.contains(feature)) {
                    throw new InputException(file + ": requires a reader with the feature '" + PlainText.value(feature)
                            + "', which is not supported; 'osmium cat' writes a file without it");
                }
            } else {
                reader.skip();
            }
        }
    }

    private void block(byte[] bytes) throws IOException {
        granularity = 100;
        latitudeOffset = 0;
        longitudeOffset = 0;
        // What applies to all groups comes before and after them.
        for (ProtoReader reader = new ProtoReader(bytes); reader.next(); ) {
            switch (reader.field()) {
                case 1 -> strings = PbfStrings.of(reader.message());
                case 17 -> granularity = reader.number();
                case 19 -> latitudeOffset = reader.number();
                case 20 -> longitudeOffset = reader.number();
                default -> reader.skip();
            }
        }
        for (ProtoReader reader = new ProtoReader(bytes); reader.next(); ) {
            if (reader.field() == 2) {
                group(reader.message());
            } else {
                reader.skip();
            }
        }
    }

    private void group(ProtoReader group) throws IOException {
        while (group.next()) {
            switch (group.field()) {
                case 1 -> node(group.message());
                case 2 -> dense(group.message());
                case 3 -> way(group.message());
                case 4 -> relation(group.message());
                default -> group.skip();
            }
        }
    }

    private void node(ProtoReader node) throws IOException {
        long id = 0;
        long latitude = 0;
        long longitude = 0;
        long[] keys = {};
        long[] values = {};
        while (node.next()) {
            switch (node.field()) {
                case 1 -> id = node.signed();
                case 2 -> keys = numbers(node.message());
                case 3 -> values = numbers(node.message());
                case 8 -> latitude = node.signed();
                case 9 -> longitude = node.signed();
                default -> node.skip();
            }
        }
        target.node(id, longitude(longitude), latitude(latitude));
        if (keys.length > 0) {
            target.taggedNode(tags(keys, values));
        }
    }

    private double latitude(long units) throws IOException {
        return degrees(latitudeOffset + granularity * units, 90.0);
    }

    private double longitude(long units) throws IOException {
        return degrees(longitudeOffset + granularity * units, 180.0);
    }

    private static double degrees(long nanodegrees, double most) throws IOException {
        // A quotient by a power of ten is the closest number to the decimal fraction; a product is not.
        double degrees = nanodegrees / PER_DEGREE;
        if (!(Math.abs(degrees) <= most)) {
            throw new IOException("a node at " + degrees + " degrees; the limit is " + most);
        }
        return degrees;
    }

    private void dense(ProtoReader dense) throws IOException {
        long[] ids = {};
        long[] latitudes = {};
        long[] longitudes = {};
        ProtoReader keysAndValues = new ProtoReader(new byte[0]);
        while (dense.next()) {
            switch (dense.field()) {
                case 1 -> ids = sums(dense.message());
                case 8 -> latitudes = sums(dense.message());
                case 9 -> longitudes = sums(dense.message());
                case 10 -> keysAndValues = dense.message();
                default -> dense.skip();
            }
        }
        if (latitudes.length != ids.length || longitudes.length != ids.length) {
            throw new IOException(ids.length + " nodes with " + latitudes.length + " latitudes and " + longitudes.length
                    + " longitudes");
        }
        for (int i = 0; i < ids.length; i++) {
            target.node(ids[i], longitude(longitudes[i]), latitude(latitudes[i]));
            Map<String, String> tags = new HashMap<>();
            while (keysAndValues.hasMore()) {
                long key = keysAndValues.packed();
                if (key == 0) {
                    break;
                }
                tags.put(strings.get(key), strings.get(keysAndValues.packed()));
                OsmElements.checkTags(tags.size());
            }
            if (!tags.isEmpty()) {
                target.taggedNode(tags);
            }
        }
    }

    private void way(ProtoReader way) throws IOException {
        long id = 0;
        long[] keys = {};
        long[] values = {};
        long[] nodes = {};
        while (way.next()) {
            switch (way.field()) {
                case 1 -> id = way.number();
                case 2 -> keys = numbers(way.message());
                case 3 -> values = numbers(way.message());
                case 8 -> nodes = sums(way.message());
                default -> way.skip();
            }
        }
        target.way(id, nodes, tags(keys, values));
    }

    private void relation(ProtoReader relation) throws IOException {
        long id = 0;
        long[] keys = {};
        long[] values = {};
        long[] roles = {};
        long[] types = {};
        long[] ids = {};
        while (relation.next()) {
            switch (relation.field()) {
                case 1 -> id = relation.number();
                case 2 -> keys = numbers(relation.message());
                case 3 -> values = numbers(relation.message());
                case 8 -> roles = numbers(relation.message());
                case 9 -> ids = sums(relation.message());
                case 10 -> types = numbers(relation.message());
                default -> relation.skip();
            }
        }
        if (roles.length != ids.length || types.length != ids.length) {
            throw new IOException("relation " + id + " has " + ids.length + " members, " + roles.length + " roles and "
                    + types.length + " types");
        }
        OsmElements.checkMembers(ids.length);
        List<OsmElements.Member> members = new ArrayList<>();
        for (int i = 0; i < ids.length; i++) {
            if (types[i] == WAY) {
                members.add(new OsmElements.Member(ids[i], strings.get(roles[i])));
            }
        }
        target.relation(id, members, tags(keys, values));
    }

    private Map<String, String> tags(long[] keys, long[] values) throws IOException {
        if (keys.length != values.length) {
            throw new IOException(keys.length + " keys with " + values.length + " values");
        }
        OsmElements.checkTags(keys.length);
        Map<String, String> tags = new HashMap<>();
        for (int i = 0; i < keys.length; i++) {
            tags.put(strings.get(keys[i]), strings.get(values[i]));
        }
        return tags;
    }

    private static long[] numbers(ProtoReader packed) throws IOException {
        long[] numbers = new long[packed.countPacked()];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = packed.packed();
        }
        return numbers;
    }

    /** Numbers that are written as differences, each from the one before. */
    private static long[] sums(ProtoReader packed) throws IOException {
        long[] sums = new long[packed.countPacked()];
        long sum = 0;
        for (int i = 0; i < sums.length; i++) {
            sum += packed.packedSigned();
            sums[i] = sum;
        }
        return sums;
    }
}

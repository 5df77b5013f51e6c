package org.dronewatch.run.store;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronewatch.buildings.LoadedBuildings;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.TreeParts;
import org.dronewatch.setting.input.FileHash;
import org.dronewatch.terrain.KnownGround;
import org.dronewatch.terrain.LoadedTerrain;
import org.dronewatch.terrain.TerrainGround;

/**
 * The layout of the store's files: the first line below, then what the form adds, then the checksum (8 bytes) of
 * everything before it.
 *
 * <pre>
 *   int  MAGIC, int VERSION, text key         (see StoreKey)
 *   mesh       floats vertices, ints corners, ints materials, ints source numbers, texts names of materials
 *   terrain    mesh, int posts, int holes, int all triangles, double error, files, texts description, texts warnings,
 *              doubles rim
 *   buildings  mesh, mesh of woods, colours (int count; text, int each), outlines (int count; see below each),
 *              texts attribution (none or one), int count, double area, int assumed, file, ints runs of land
 *              cover, int side (0 for none), double half of the square, texts description, texts warnings
 *   outline    text id, texts name (none or one), int is it a part, doubles outer, int count of courts, doubles each,
 *              double bottom, double top, int is its height assumed
 *   file       text name, text SHA-256; files: int count, then each
 *   tree       longs nodes, ints triangles of leaves, ints numbers of triangles, int depth
 * </pre>
 *
 * <p>All numbers are little-endian; arrays and texts (UTF-8) are preceded by their length as an int. Change {@link
 * #VERSION} with every change of the layout, including the forms of other packages.
 */
final class StoredForms {
    static final int MAGIC = 0x5345_5744;
    static final int VERSION = 3;

    /** A terrain. */
    static final StoredForm<PreparedTerrain> TERRAIN = new TerrainForm();

    /** Buildings. */
    static final StoredForm<LoadedBuildings> BUILDINGS = new BuildingsForm();

    /** A tree without its mesh. */
    static final StoredForm<TreeParts> TREE = new TreeForm();

    private StoredForms() {}

    private static final class TerrainForm implements StoredForm<PreparedTerrain> {
        @Override
        public void write(PreparedTerrain value, StoreWriter target) throws IOException {
            LoadedTerrain terrain = value.terrain();
            addMesh(terrain.mesh(), target);
            target.addInt(terrain.posts());
            target.addInt(terrain.holes());
            target.addInt(terrain.all());
            target.addDouble(terrain.error());
            target.addInt(terrain.files().size());
            for (FileHash file : terrain.files()) {
                addFile(file, target);
            }
            target.addTexts(terrain.description());
            target.addTexts(terrain.warnings());
            target.addDoubles(value.ground().rim());
        }

        @Override
        public PreparedTerrain read(StoreReader source) throws IOException {
            TriangleMesh mesh = nextMesh(source);
            int posts = source.nextInt();
            int holes = source.nextInt();
            int all = source.nextInt();
            double error = source.nextDouble();
            List<FileHash> files = new ArrayList<>();
            for (int left = source.length(2 * Integer.BYTES); left > 0; left--) {
                files.add(nextFile(source));
            }
            LoadedTerrain terrain =
                    new LoadedTerrain(mesh, posts, holes, all, error, files, source.nextTexts(), source.nextTexts());
            return new PreparedTerrain(terrain, new KnownGround(new TerrainGround(mesh), source.nextDoubles()));
        }
    }

    private static final class TreeForm implements StoredForm<TreeParts> {
        @Override
        public void write(TreeParts value, StoreWriter target) throws IOException {
            target.addLongs(value.nodes());
            target.addInts(value.leafTriangles());
            target.addInts(value.numbers());
            target.addInt(value.depth());
        }

        @Override
        public TreeParts read(StoreReader source) throws IOException {
            return new TreeParts(source.nextLongs(), source.nextInts(), source.nextInts(), source.nextInt());
        }
    }

    static void addMesh(TriangleMesh mesh, StoreWriter target) throws IOException {
        target.addFloats(mesh.vertices());
        target.addInts(mesh.corners());
        target.addInts(mesh.materials());
        target.addInts(mesh.sourceNumbers());
        target.addTexts(mesh.materialNames());
    }

    static TriangleMesh nextMesh(StoreReader source) throws IOException {
        return new TriangleMesh(
                source.nextFloats(), source.nextInts(), source.nextInts(), source.nextInts(), source.nextTexts());
    }

    static void addFile(FileHash file, StoreWriter target) throws IOException {
        target.addText(file.file());
        target.addText(file.sha256());
    }

    static FileHash nextFile(StoreReader source) throws IOException {
        return new FileHash(source.nextText(), source.nextText());
    }

    static void addOptional(Optional<String> text, StoreWriter target) throws IOException {
        target.addTexts(text.map(List::of).orElse(List.of()));
    }

    static Optional<String> nextOptional(StoreReader source) throws IOException {
        return source.nextTexts().stream().findFirst();
    }
}

package org.dronewatch.mesh.io;

import java.io.IOException;
import java.io.Reader;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.parallel.Workers;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.input.FileHash;

/**
 * Reads Wavefront OBJ files with the materials of their MTL files. Polygons are cut into triangles, as a fan if the fan
 * covers the polygon exactly; triangles without area are dropped and counted; lines, curves, normals, texture
 * coordinates and everything else in the format are skipped and counted. An invalid statement causes an
 * {@link InputException} that names the file and the line.
 */
public final class ObjReader implements MeshReader {
    @Override
    public Set<String> extensions() {
        return Set.of("obj");
    }

    @Override
    public String summary() {
        return "Wavefront OBJ, with its MTL files";
    }

    @Override
    public LoadedModel read(ModelFile file, ModelSettings settings) {
        AtomicReference<ObjMeshCollector> collected = new AtomicReference<>();
        AtomicReference<FileHash> hash = new AtomicReference<>();
        Workers.both(() -> collected.set(collect(file, file.placement(settings))), () -> hash.set(file.hash()));
        ObjMeshCollector collector = collected.get();
        List<String> warnings = new ArrayList<>(collector.warnings());
        TriangleMesh mesh = collector.toMesh(warnings);
        List<FileHash> files = new ArrayList<>(List.of(hash.get()));
        MaterialLibraries materials = new MaterialLibraries(file);
        materials.read(collector.libraries(), collector.materialNames());
        files.addAll(materials.files());
        warnings.addAll(materials.warnings());
        int dropped = collector.triangles() - mesh.triangleCount();
        return new LoadedModel(file.name(), mesh, dropped, collector.skipped(), materials.colours(), files, warnings);
    }

    private static ObjMeshCollector collect(ModelFile file, Placement placement) {
        try (Reader text = file.text();
                ObjLines lines = new ObjLines(text)) {
            ObjMeshCollector collector = new ObjMeshCollector(file.name(), lines, placement);
            try {
                new ObjParser(file.name(), lines, collector).read();
            } catch (IOException e) {
                throw new InputException(lines.at(file.name()) + e.getMessage(), e);
            }
            collector.finish();
            return collector;
        } catch (IOException e) {
            throw new InputException("model file " + file.name() + " cannot be read: " + e.getMessage(), e);
        }
    }
}

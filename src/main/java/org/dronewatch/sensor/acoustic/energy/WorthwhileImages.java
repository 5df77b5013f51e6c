package org.dronewatch.sensor.acoustic.energy;

import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.imagesource.ImageSources;
import org.dronewatch.sensor.acoustic.imagesource.WallPlanes;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.World;

/** Chooses image sources whose purely specular paths are worth searching for: there may be thousands. Immutable. */
final class WorthwhileImages {
    /**
     * Image sources with a purely specular path are left to the rays that happen to pass the source if one of them
     * increases the relative variance of a reading by less than this.
     */
    private static final double HARDLY_ANYTHING = 1e-6;

    private final WallPlanes planes;
    private final double ofOneRay;

    /**
     * For each wall, the fraction of the energy that its best reflector reflects specularly, averaged over all bands.
     */
    private final double[] mirrored;

    /**
     * Image sources in the walls of a world.
     *
     * @param ofOneRay contribution of one ray that passes the source, as intensity divided by the source's power, 1/m2
     */
    WorthwhileImages(World world, WallPlanes planes, BandSurfaces surfaces, double ofOneRay) {
        this.planes = planes;
        this.ofOneRay = ofOneRay;
        this.mirrored = new double[planes.count()];
        for (int wall = 0; wall < mirrored.length; wall++) {
            mirrored[wall] = world.materialsOf(planes.triangleOf(wall))
                    .mapToDouble(material -> mirrored(material, surfaces))
                    .max()
                    .orElseThrow();
        }
    }

    private static double mirrored(int material, BandSurfaces surfaces) {
        double mean = 0.0;
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            mean += surfaces.mirrored(material, band) / OctaveBands.COUNT;
        }
        return mean;
    }

    /**
     * The image sources that are worth searching for, and their parents.
     *
     * @param from position from which they were found, m
     * @param to position to which they may lead, m
     * @param known the sound heard without them
     */
    ImageSources among(ImageSources imageSources, Position from, Position to, double known) {
        double[] images = new double[3 * imageSources.count()];
        imageSources.positions(from.x(), from.y(), from.z(), planes, images);
        double[] left = new double[imageSources.count()];
        left[ImageSources.ORIGINAL] = 1.0;
        boolean[] isWorthwhile = new boolean[imageSources.count()];
        for (int image = 1; image < left.length; image++) {
            left[image] = left[imageSources.parent(image)] * mirrored[imageSources.wall(image)];
            double x = images[3 * image] - to.x();
            double y = images[3 * image + 1] - to.y();
            double z = images[3 * image + 2] - to.z();
            double heard = left[image] / (4.0 * Math.PI * (x * x + y * y + z * z));
            isWorthwhile[image] = heard * left[image] * ofOneRay >= HARDLY_ANYTHING * known * known;
        }
        return imageSources.kept(isWorthwhile);
    }
}

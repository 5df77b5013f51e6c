/** The site: merged meshes with their materials, air, light, rain and noise. */
package org.dronewatch.world;

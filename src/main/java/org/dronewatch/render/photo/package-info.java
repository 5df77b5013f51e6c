/** Photographs by cameras: materials, sun, sky and haze in colour. Detection does not depend on them. */
package org.dronewatch.render.photo;

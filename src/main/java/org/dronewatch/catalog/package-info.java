/** Real sensors by name. This is the only package that depends on every kind of sensor. */
package org.dronewatch.catalog;

/** Real sensors by name: the only package that depends on every kind of sensor. */
package org.dronewatch.catalog;

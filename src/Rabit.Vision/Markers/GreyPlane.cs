using System;

namespace Rabit.Vision;

/// <summary>Grey over the square of a marker: a + b u + c v.</summary>
internal readonly struct GreyPlane(double a, double b, double c)
{
    public double At(double u, double v) => a + (b * u) + (c * v);

    /// <summary>What the least squares of a plane need.</summary>
    public struct Sums
    {
        private double _n;
        private double _u;
        private double _v;
        private double _uu;
        private double _uv;
        private double _vv;
        private double _z;
        private double _uz;
        private double _vz;

        public void Add(double u, double v, double z)
        {
            _n++;
            _u += u;
            _v += v;
            _uu += u * u;
            _uv += u * v;
            _vv += v * v;
            _z += z;
            _uz += u * z;
            _vz += v * z;
        }

        public readonly GreyPlane Solve()
        {
            double mu = _u / _n;
            double mv = _v / _n;
            double mz = _z / _n;
            double uu = _uu - (_n * mu * mu);
            double uv = _uv - (_n * mu * mv);
            double vv = _vv - (_n * mv * mv);
            double uz = _uz - (_n * mu * mz);
            double vz = _vz - (_n * mv * mz);
            double det = (uu * vv) - (uv * uv);
            if (Math.Abs(det) < 1e-12)
                return new GreyPlane(mz, 0, 0);
            double b = ((uz * vv) - (vz * uv)) / det;
            double c = ((vz * uu) - (uz * uv)) / det;
            return new GreyPlane(mz - (b * mu) - (c * mv), b, c);
        }
    }
}

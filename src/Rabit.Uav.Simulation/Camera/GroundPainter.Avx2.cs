#if NET
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace Rabit.Uav.Simulation;

// The same arithmetic as for one pixel, in the same order, so that the pictures are the same to the byte.
internal sealed partial class GroundPainter
{
    // Four pixels are written as 16 bytes, of which the last four are those of the next ones.
    private const int PixelsWritten = 6;

    // From where all four are ground in front of the haze; others are painted one by one. Returns how many pixels were
    // painted.
    private int PaintFours(in GroundView view, byte[] pixels, int count)
    {
        ref double rays = ref MemoryMarshal.GetArrayDataReference(lens.Rays);
        ref byte to = ref MemoryMarshal.GetArrayDataReference(pixels);
        var right = new VectorOfFours(view.Right);
        var below = new VectorOfFours(view.Below);
        var axis = new VectorOfFours(view.Axis);
        Vector256<double> height = Vector256.Create(view.Height);
        Vector256<double> grainPerDown = Vector256.Create(view.GrainPerDown);
        int i = 0;
        for (; i <= count - PixelsWritten; i += 4)
        {
            Vector256<double> first = Vector256.LoadUnsafe(ref rays, (nuint)(2 * i));
            Vector256<double> second = Vector256.LoadUnsafe(ref rays, (nuint)((2 * i) + 4));
            Vector256<double> x = Avx2.Permute4x64(Avx.UnpackLow(first, second), 0b11_01_10_00);
            Vector256<double> y = Avx2.Permute4x64(Avx.UnpackHigh(first, second), 0b11_01_10_00);
            Vector256<double> down = (x * right.Third) + (y * below.Third) + axis.Third;
            Vector256<double> along = height / down;
            if (!Vector256.GreaterThanOrEqualAll(down, Vector256.Create(view.MinDown))
                || !Vector256.LessThanOrEqualAll(along, Vector256.Create(HazeFrom)))
            {
                PaintOnes(view, pixels, i, i + 4);
                continue;
            }

            Vector256<double> north = Vector256.Create(view.North)
                + (along * ((x * right.First) + (y * below.First) + axis.First));
            Vector256<double> east = Vector256.Create(view.East)
                + (along * ((x * right.Second) + (y * below.Second) + axis.Second));
            texture.ColoursAt(north, east, grainPerDown * down).StoreUnsafe(ref to, (nuint)(3 * i));
        }

        return i;
    }

    private readonly struct VectorOfFours(in Vector3 vector)
    {
        public readonly Vector256<double> First = Vector256.Create(vector.First);
        public readonly Vector256<double> Second = Vector256.Create(vector.Second);
        public readonly Vector256<double> Third = Vector256.Create(vector.Third);
    }
}
#endif

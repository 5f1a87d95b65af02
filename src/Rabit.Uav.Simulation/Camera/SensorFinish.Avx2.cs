#if NET
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace Rabit.Uav.Simulation;

// Sixteen bytes at a time, to the same values as one by one.
internal sealed partial class SensorFinish
{
    // The whole sixteens of a row. Returns how many bytes that are.
    private int FinishSixteens(byte[] pixels, int from, int noiseFrom)
    {
        ref byte levels = ref MemoryMarshal.GetArrayDataReference(pixels);
        ref short gains = ref MemoryMarshal.GetArrayDataReference(_gains);
        ref short noises = ref MemoryMarshal.GetArrayDataReference(_noise);
        int done = 0;
        for (; done <= _rowLength - Vector128<byte>.Count; done += Vector128<byte>.Count)
        {
            nuint at = (nuint)(from + done);
            Vector256<short> level = Avx2.ConvertToVector256Int16(Vector128.LoadUnsafe(ref levels, at));
            Vector256<short> gain = Vector256.LoadUnsafe(ref gains, at);
            Vector256<short> noise = Vector256.LoadUnsafe(ref noises, (nuint)(noiseFrom + done));

            // level * gain + 1 * noise, as pairs beside each other.
            Vector256<int> low = Avx2.MultiplyAddAdjacent(
                Avx2.UnpackLow(level, Vector256<short>.One), Avx2.UnpackLow(gain, noise));
            Vector256<int> high = Avx2.MultiplyAddAdjacent(
                Avx2.UnpackHigh(level, Vector256<short>.One), Avx2.UnpackHigh(gain, noise));
            Vector256<short> finished = Avx2.PackSignedSaturate(Rounded(low), Rounded(high));
            Sse2.PackUnsignedSaturate(finished.GetLower(), finished.GetUpper()).StoreUnsafe(ref levels, at);
        }

        return done;
    }

    private static Vector256<int> Rounded(Vector256<int> value) => (value + Vector256.Create(128)) >> 8;
}
#endif

using System.Security.Cryptography;

namespace Rabit.Uav.MissionControl;

// netstandard2.0 has no static method for it.
internal static partial class Sha256Hex
{
    private static byte[] Hash(byte[] bytes)
    {
        using var hash = SHA256.Create();
        return hash.ComputeHash(bytes);
    }
}

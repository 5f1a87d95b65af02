using System.Security.Cryptography;

namespace Rabit.Uav.MissionControl;

// .NET hashes without an object.
internal static partial class Sha256Hex
{
    private static byte[] Hash(byte[] bytes) => SHA256.HashData(bytes);
}

using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Diagnostics.Tests.Api;

/// <summary>
/// The public surface of the package changes only on purpose. To change it: run <c>RABIT_UPDATE_API=1 dotnet test
/// tests/Rabit.Diagnostics.Tests</c>, and commit PublicApi.txt together with the change.
/// </summary>
public sealed class PublicApiTests
{
    [Fact]
    public void PublicSurface_OfTheAssembly_IsThatOfTheFile()
        => PublicApiText.AssertUnchanged(
            typeof(RabitDiagnostics).Assembly, "tests/Rabit.Diagnostics.Tests/Api/PublicApi.txt");
}

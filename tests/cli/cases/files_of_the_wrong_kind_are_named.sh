#!/usr/bin/env bash
# Every kind of file given to every command that takes another: it is named, with the command that takes it.
# Needs time: every kind of file in every command.
source "$(dirname "$0")/../harness.sh"

files=$folder/files
mkdir "$files"
small_study 4 >"$files/study"
printf '[[gate]]\nname = "g"\nkind = "bias"\nquantity = "q"\nreference = 1\nband = 1\n' >"$files/bands"
printf '[[surface]]\nface = "a"\nshape = "disc"\ncentre = [0, 0, 0]\nnormal = [0, 0, 1]\nradius = 1\n' >"$files/toml_scene"
printf '# a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >"$files/obj"
printf 'T t\nF 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 0 1 0\nS 1 1 2 3 0 0 0 0.9 a\n' >"$files/vs3"
cp "$data/../../studies/built_in/paper_tables.json" "$files/tables"
printf '{"schema": "ffstudy.baseline/1", "gates": []}\n' >"$files/baseline"
printf 'trial,quantity,estimate\n0,q,1\n' >"$files/estimates"
printf 'quantity,bin,mean,standard_error,n\nq,1,1,0.1,10\n' >"$files/means"
printf 'solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid x\n' >"$files/stl"
ffstudy run "$files/study" --out "$folder/kept" --quiet
expect_status 0
cp "$folder/kept/results.sqlite" "$files/store"
ffstudy form-factors cube --out "$folder/factors" --quiet
expect_status 0
cp "$folder/factors/form_factors.sqlite" "$files/factors"
ffstudy points sobol --n 16 --out "$folder/points.npy"
expect_status 0
cp "$folder/points.npy" "$files/points"

# what KIND: how it is named; taken_by KIND FILE: the command that is suggested.
what() {
    case $1 in
        study) echo "a study file" ;; bands) echo "a bands file" ;; toml_scene | obj | vs3 | stl) echo "a scene file" ;;
        tables) echo "a tables file" ;; baseline) echo "a baseline" ;; estimates | means) echo "a file of estimates" ;;
        store) echo "a result store" ;; factors) echo "a store of form factors" ;;
        points) echo "a file of points" ;;
    esac
}
taken_by() {
    case $1 in
        study) echo "run $2" ;; bands) echo "check $2" ;; toml_scene | obj | vs3 | stl) echo "form-factors $2" ;;
        tables) echo "audit $2" ;; baseline) echo "check BANDS.toml --baseline $2" ;;
        estimates | means) echo "check BANDS.toml --estimates $2" ;; store) echo "report $2" ;;
        factors) echo "form-factors --load $2" ;; points) echo "convergence --sampler file:$2" ;;
    esac
}

# refuse WANTED COMMAND...: every file but those of the kind WANTED; {} stands for the file.
refuse() {
    local wanted=$1 kind file
    shift
    for kind in study bands toml_scene obj vs3 stl tables baseline estimates means store factors points; do
        [ "$(what $kind)" != "$(what "$wanted")" ] || continue
        file=$files/$kind
        [ "$wanted" != obj ] || { file=$folder/$kind.obj && cp "$files/$kind" "$file"; }
        ffstudy "${@/\{\}/$file}"
        expect_refused 2 "$file: $(what $kind) (expected $(what "$wanted")). Run 'ffstudy $(taken_by $kind "$file")'."
    done
}
# What no command takes is named too.
foreign() {
    printf "$1" >"$folder/picture"
    ffstudy run "$folder/picture"
    expect_refused 2 "picture: $2 (expected a study file). Check the name."
}
foreign '\x89PNG\r\n\x1a\n\0' "a PNG picture"
foreign 'PK\x03\x04\0' "a ZIP archive (as .npz is)"
foreign 'SQLite format 3\0' "a SQLite database"
foreign '\x7fELF\0' "a program or a library"

# A table of unknown columns.
printf 'pair;value\n1-2;0.2\n' >"$folder/semicolons.csv"
ffstudy check "$folder/semicolons.csv"
expect_refused 2 "semicolons.csv: a file of estimates (expected a bands file). Run 'ffstudy check BANDS.toml --estimates"

refuse study run {}
refuse study radiosity {}
refuse bands check {}
refuse tables audit {}
refuse baseline check "$files/bands" --baseline {}
refuse estimates check "$files/bands" --estimates {}
refuse store report {}
refuse store compare {} "$folder/kept"
refuse store merge {} --out merged
refuse factors form_factors --load {}
refuse obj form_factors {}
refuse obj explain {}

# A file where a command is wanted.
for kind in study bands toml_scene obj vs3 stl tables baseline estimates means store factors points; do
    ffstudy "$files/$kind"
    expect_refused 2 "'$files/$kind' is $(what $kind), not a command. Run 'ffstudy $(taken_by $kind "$files/$kind")'."
done

# A file without the extension of a scene, and something that is not a file at all.
ffstudy form-factors "$files/study"
expect_refused 2 "a study file (expected a scene file). Run 'ffstudy run $files/study'."
ffstudy form-factors "$files/obj"
expect_refused 2 "its extension names no scene format (.obj, .toml, .vs3, .idf, .epJSON, .stl, .ply, .off, .gltf, .glb, .vtk, .vtu, .vtp, .msh). Give a scene file, or a name of 'ffstudy list scenes'."
/usr/bin/python3 -c 'import sys; sys.stdout.buffer.write(bytes(80) + b"\1\0\0\0" + bytes(50))' >"$folder/stl.obj"
ffstudy form-factors "$folder/stl.obj"
expect_refused 2 "an STL file by its content (its name says that it is something else). Rename it to end in .stl."
mkfifo "$folder/fifo"
ffstudy report "$folder/fifo"
expect_refused 3 "fifo: a FIFO, not a file."
